// Relievo from outside: a vertical ray onto a flat relief of depth ¼ stops at ¼.
#include <relievo/reference/bilinear_tracer.h>
#include <relievo/textures/plane.h>

int main() {
    const relievo::textures::DepthMap map{.depth = relievo::textures::Plane(4, 4, 0.25f)};
    const relievo::reference::TileRay ray{.origin = {0.5, 0.5, 0.0}, .direction = {0.0, 0.0, 1.0}};
    const auto hit = relievo::reference::traceBilinear(map, ray);
    return hit && hit->position.z == 0.25 ? 0 : 1;
}
