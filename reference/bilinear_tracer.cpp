#include "reference/bilinear_tracer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "reference/bilinear_cell.h"
#include "reference/cell_walk.h"

namespace relievo::reference {

namespace {

using textures::DepthMap;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthestTexel = 0x1p51;

/// The part of a ray inside the box window × [0,1]: the parameters of its ends and the point where
/// it begins.
struct ClippedRay {
    double begin = 0.0;
    double end = kInfinity;
    glm::dvec3 start{0.0};
    bool endsOnFloor = false;  ///< leaves through z = 1, where everything is solid
};

bool isFinite(const TileRay& ray) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(ray.origin[axis]) || !std::isfinite(ray.direction[axis]))
            return false;
    return true;
}

std::optional<ClippedRay> clip(const TileRay& ray, const TileWindow& window) {
    const glm::dvec3 low(window.minimum, 0.0);
    const glm::dvec3 high(window.maximum, 1.0);
    ClippedRay clipped;
    glm::dvec3 entry(-kInfinity);
    double floorExit = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (direction == 0.0) {
            if (origin < low[axis] || origin > high[axis])
                return std::nullopt;
            continue;
        }
        const bool forward = direction > 0.0;
        entry[axis] = ((forward ? low : high)[axis] - origin) / direction;
        const double exit = ((forward ? high : low)[axis] - origin) / direction;
        clipped.begin = std::max(clipped.begin, entry[axis]);
        clipped.end = std::min(clipped.end, exit);
        if (axis == 2 && forward)
            floorExit = exit;
    }
    if (clipped.begin > clipped.end)
        return std::nullopt;
    clipped.endsOnFloor = clipped.end == floorExit && floorExit < kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        // On the side through which the ray comes in the coordinate is the bound itself: computed,
        // it could lie a rounding below a surface that touches z = 0.
        const bool entersHere = entry[axis] == clipped.begin;
        clipped.start[axis] = entersHere ? (ray.direction[axis] > 0.0 ? low : high)[axis]
                                         : ray.origin[axis] + clipped.begin * ray.direction[axis];
    }
    return clipped;
}

struct Crossing {
    double t = 0.0;
    bool startsInside = false;
};

/// `endsOnFloor`: the walk ends on z = 1, where everything is solid.
std::optional<Crossing> walkToSurface(CellWalk walk, bool endsOnFloor) {
    for (bool first = true;; first = false, walk.step()) {
        const BilinearCell cell = walk.surface();
        if (walk.deepest() >= cell.minimum) {
            const DepthBelowSurface below = walk.below(cell);
            const double entry = walk.entry();
            if (const auto s = firstCrossing(below); s && entry + *s <= walk.exit())
                return Crossing{entry + *s, first && below.constant > 0.0};
        }
        if (walk.isLast())  // no depth exceeds 1, so only rounding can bring a ray to the floor
                            // unhurt
            return endsOnFloor ? std::optional(Crossing{walk.exit(), false}) : std::nullopt;
    }
}

}  // namespace

std::optional<TileHit> traceBilinear(const DepthMap& map, const TileRay& ray,
                                     const TileWindow& window, double maxDistance) {
    assert(map.width() > 0 && map.height() > 0);
    assert(maxDistance >= 0.0 && std::isfinite(maxDistance));
    if (!isFinite(ray))
        return std::nullopt;
    const std::optional<ClippedRay> clipped = clip(ray, window);
    if (!clipped)
        return std::nullopt;
    const glm::dvec2 size(map.width(), map.height());
    const glm::dvec2 texels = glm::dvec2(clipped->start) * size - 0.5;
    if (!(std::max(std::abs(texels.x), std::abs(texels.y)) < kFarthestTexel))
        return std::nullopt;

    // A power of two brings any length of direction to about 1 without rounding, so that the
    // squares below neither overflow nor vanish.
    const double longest =
        std::max({std::abs(ray.direction.x), std::abs(ray.direction.y), std::abs(ray.direction.z)});
    const int exponent = longest > 0.0 ? std::ilogb(longest) : 0;
    const glm::dvec3 direction(std::scalbn(ray.direction.x, -exponent),
                               std::scalbn(ray.direction.y, -exponent),
                               std::scalbn(ray.direction.z, -exponent));
    const double reach = std::scalbn(clipped->end - clipped->begin, exponent);
    const double tilesPerUnit = std::hypot(direction.x, map.aspect() * direction.y);
    const double limit = tilesPerUnit > 0.0 ? maxDistance / tilesPerUnit : kInfinity;
    const std::optional<Crossing> crossing =
        walkToSurface(CellWalk(map, clipped->start, direction, std::min(reach, limit)),
                      clipped->endsOnFloor && reach <= limit);
    if (!crossing)
        return std::nullopt;
    return TileHit{clipped->begin + std::scalbn(crossing->t, -exponent),
                   clipped->start + crossing->t * direction, crossing->startsInside};
}

glm::dvec3 bilinearNormal(const DepthMap& map, double u, double v, double depthScale) {
    assert(map.width() > 0 && map.height() > 0);
    const CellWalk walk(map, {u, v, 0.0}, glm::dvec3(0.0), 0.0);
    const glm::dvec2 perTexel = walk.surface().gradient(walk.local(0.0));
    const glm::dvec2 texel(1.0, map.texelAspect);  // in texel widths, of which a tile has `width`
    const glm::dvec2 slope = depthScale * map.width() * perTexel / texel;
    return glm::normalize(glm::dvec3(slope, 1.0));
}

}  // namespace relievo::reference
