// Binary search between a point above the surface and one in the solid.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

// Halves [outside, inside] `count` times, keeping a crossing of the surface between them.
void reliefBisect(ReliefRay ray, int count, inout float outside, inout float inside,
                  inout int steps) {
    for (int i = 0; i < count; ++i) {
        ++steps;
        float middle = 0.5 * (outside + inside);
        vec3 point = reliefPoint(ray, middle);
        if (point.z >= reliefDepth(point.xy)) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
}
