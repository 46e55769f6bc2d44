#include "reference/surface_crossings.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "reference/bilinear_cell.h"
#include "reference/cell_walk.h"

namespace relievo::reference {

namespace {

// A stretch of a ray in one cell on which z − D only grows or only falls.
struct Stretch {
    const DepthBelowSurface& below;
    double entry;       // of the cell: the ray's parameter at s = 0
    double begin, end;  // s

    [[nodiscard]] double valueAt(double s) const {
        return below.constant + (below.linear + below.quadratic * s) * s;
    }
};

// Calls visit(stretch) for the stretches in order. A cell in which the ray is above the surface for
// certain is left out while `wantsAbove()` does not hold.
template <class WantsAbove, class Visit>
void forStretches(CellWalk walk, const WantsAbove& wantsAbove, const Visit& visit) {
    for (;; walk.step()) {
        const BilinearCell cell = walk.surface();
        if (wantsAbove() || walk.deepest() >= cell.minimum) {
            const DepthBelowSurface below = walk.below(cell);
            const double length = walk.exit() - walk.entry();
            const double vertex = -0.5 * below.linear / below.quadratic;
            if (vertex > 0.0 && vertex < length) {
                visit(Stretch{below, walk.entry(), 0.0, vertex});
                visit(Stretch{below, walk.entry(), vertex, length});
            } else {
                visit(Stretch{below, walk.entry(), 0.0, length});
            }
        }
        if (walk.isLast())
            return;
    }
}

// The s at which a stretch whose ends have different signs passes through the surface.
double rootIn(const Stretch& stretch) {
    const auto [q0, q1, q2] = stretch.below;
    const double discriminant = std::max(q1 * q1 - 4.0 * q2 * q0, 0.0);
    const double q = -0.5 * (q1 + std::copysign(std::sqrt(discriminant), q1));
    const auto distance = [&](double s) {
        return std::isfinite(s) ? std::max({0.0, stretch.begin - s, s - stretch.end}) : HUGE_VAL;
    };
    const double first = q0 / q;
    const double second = q / q2;
    return std::clamp(distance(first) <= distance(second) ? first : second, stretch.begin,
                      stretch.end);
}

CellWalk walkAlong(const textures::DepthMap& map, const TileRay& ray, double end) {
    assert(map.width() > 0 && map.height() > 0);
    assert(std::isfinite(end) && end >= 0.0);
    return {map, ray.origin, ray.direction, end};
}

}  // namespace

std::vector<SurfaceCrossing> surfaceCrossings(const textures::DepthMap& map, const TileRay& ray,
                                              double end, double tolerance) {
    std::vector<SurfaceCrossing> crossings;
    std::optional<bool> isBelow;  // nothing until the ray has left the tolerance for one side
    double candidate = 0.0;       // the last passage to the other side
    const auto visit = [&](const Stretch& stretch) {
        const double from = stretch.valueAt(stretch.begin);
        const double to = stretch.valueAt(stretch.end);
        if (!isBelow && std::abs(from) > tolerance)
            isBelow = from > 0.0;
        if ((from <= 0.0) != (to <= 0.0))
            candidate = stretch.entry + rootIn(stretch);
        if (std::abs(to) <= tolerance || isBelow == (to > 0.0))
            return;
        if (isBelow || to > 0.0)
            crossings.push_back({candidate, to > 0.0});
        isBelow = to > 0.0;
    };
    forStretches(
        walkAlong(map, ray, end), [&] { return isBelow.value_or(true); }, visit);
    return crossings;
}

bool getsBelow(const textures::DepthMap& map, const TileRay& ray, double end, double tolerance) {
    for (CellWalk walk = walkAlong(map, ray, end);; walk.step()) {
        const BilinearCell cell = walk.surface();
        if (walk.deepest() > cell.minimum + tolerance) {
            const auto [q0, q1, q2] = walk.below(cell);
            const double length = walk.exit() - walk.entry();
            const double vertex = q2 < 0.0 ? std::clamp(-0.5 * q1 / q2, 0.0, length) : 0.0;
            for (const double s : {0.0, vertex, length})
                if (q0 + (q1 + q2 * s) * s > tolerance)
                    return true;
        }
        if (walk.isLast())
            return false;
    }
}

Excursion deepestBelow(const textures::DepthMap& map, const TileRay& ray, double end) {
    Excursion deepest;
    const auto visit = [&](const Stretch& stretch) {
        for (const double s : {stretch.begin, stretch.end})
            if (const double depth = stretch.valueAt(s); depth > deepest.depth)
                deepest = {depth, stretch.entry + s};
    };
    forStretches(
        walkAlong(map, ray, end), [] { return false; }, visit);
    return deepest;
}

Excursion farthestReappearance(const textures::DepthMap& map, const TileRay& ray, double end,
                               double tolerance) {
    bool pierced = false;
    Excursion farthest;
    const auto visit = [&](const Stretch& stretch) {
        for (const double s : {stretch.begin, stretch.end}) {
            const double depth = stretch.valueAt(s);
            pierced = pierced || depth > tolerance;
            if (pierced && -depth > farthest.depth)
                farthest = {-depth, stretch.entry + s};
        }
    };
    forStretches(
        walkAlong(map, ray, end), [&] { return pierced; }, visit);
    return farthest;
}

}  // namespace relievo::reference
