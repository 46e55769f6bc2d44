#include "reference/visibility.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/cell_walk.h"
#include "reference/surface_crossings.h"

namespace relievo::reference {

namespace {

using textures::DepthMap;

// The parameter at which a ray that goes up leaves the window, the relief or the distance.
double endOf(const DepthMap& map, const TileRay& ray, const TileWindow& window,
             double maxDistance) {
    const double tilesPerUnit = std::hypot(ray.direction.x, map.aspect() * ray.direction.y);
    double end = -ray.origin.z / ray.direction.z;
    if (tilesPerUnit > 0.0)
        end = std::min(end, maxDistance / tilesPerUnit);
    for (int axis = 0; axis < 2; ++axis)
        if (const double direction = ray.direction[axis]; direction != 0.0) {
            const double border = (direction > 0.0 ? window.maximum : window.minimum)[axis];
            end = std::min(end, (border - ray.origin[axis]) / direction);
        }
    return std::max(end, 0.0);
}

double depthAt(const DepthMap& map, const glm::dvec2& place) {
    const CellWalk walk(map, {place, 0.0}, glm::dvec3(0.0), 0.0);
    return walk.surface().depth(walk.local(0.0));
}

}  // namespace

bool isLit(const DepthMap& map, const glm::dvec2& place, const glm::dvec3& direction,
           const TileWindow& window, double maxDistance) {
    if (!(direction.z < 0.0))
        return false;
    const TileRay ray{{place, depthAt(map, place)}, direction};
    return !getsBelow(map, ray, endOf(map, ray, window, maxDistance));
}

double visibleShare(const DepthMap& map, const glm::dvec2& place, const DiscLight& light, int rays,
                    const TileWindow& window, double maxDistance) {
    assert(rays >= 1);
    const auto lit = [&](double x, double y) {
        return isLit(map, place, light.centre + x * light.lift + y * light.side, window,
                     maxDistance);
    };
    if (light.lift == glm::dvec3(0.0) && light.side == glm::dvec3(0.0))
        return lit(0.0, 0.0) ? 1.0 : 0.0;
    constexpr double kGoldenAngle = std::numbers::pi * (3.0 - 2.23606797749978969641);
    int seen = 0;
    for (int k = 0; k < rays; ++k) {
        const double radius = std::sqrt((k + 0.5) / rays);
        seen += lit(radius * std::cos(k * kGoldenAngle), radius * std::sin(k * kGoldenAngle));
    }
    return static_cast<double>(seen) / rays;
}

}  // namespace relievo::reference
