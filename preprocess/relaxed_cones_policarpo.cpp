#include "preprocess/relaxed_cones_policarpo.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

// A point over the map: steps of index from texel (0,0), and normalised depth.
struct Point {
    double x;
    double y;
    double z;
};

double depthAt(const textures::DepthMap& map, double x, double y) {
    const double left = std::floor(x);
    const double top = std::floor(y);
    const auto i = static_cast<std::int64_t>(left);
    const auto j = static_cast<std::int64_t>(top);
    const double upper = std::lerp(map.at(i, j), map.at(i + 1, j), x - left);
    const double lower = std::lerp(map.at(i, j + 1), map.at(i + 1, j + 1), x - left);
    return std::lerp(upper, lower, y - top);
}

// The first step outside the relief on the ray through (i,j,0) and the surface point `entry`, as
// long as it is above the bottom. A ray at depth 0 is level and meets no bottom: nothing after as
// many texels as the map has in both directions.
std::optional<Point> firstOutside(const textures::DepthMap& map, int i, int j, const Point& entry,
                                  int steps) {
    const double across = entry.x - i;
    const double down = entry.y - j;
    const double perTexel = 1.0 / std::max(std::abs(across), std::abs(down));
    const double untilBottom =
        entry.z > 0.0 ? (1.0 - entry.z) / entry.z : std::numeric_limits<double>::infinity();
    const double step = std::min(perTexel, untilBottom / steps);
    const double end = std::min(untilBottom, perTexel * (map.width() + map.height()));
    for (double t = step; step > 0.0 && t <= end; t += step) {
        const Point point{entry.x + t * across, entry.y + t * down, entry.z + t * entry.z};
        if (point.z < depthAt(map, point.x, point.y))
            return point;
    }
    return std::nullopt;
}

// The least ratio of an apex, in texels per unit of depth; infinite where no ray leaves above it.
double leastRatio(const textures::DepthMap& map, int i, int j, int steps) {
    const bool repeats = map.wrap == textures::WrapMode::Repeat;
    const int left = repeats ? i - map.width() / 2 : 0;
    const int top = repeats ? j - map.height() / 2 : 0;
    const double depth = map.depth.at(i, j);
    double least = std::numeric_limits<double>::infinity();
    for (int y = top; y < top + map.height(); ++y)
        for (int x = left; x < left + map.width(); ++x) {
            const Point entry{static_cast<double>(x), static_cast<double>(y), map.at(x, y)};
            if ((x == i && y == j) || entry.z >= depth)
                continue;  // what leaves beyond it is deeper than the apex
            const std::optional<Point> exit = firstOutside(map, i, j, entry, steps);
            if (exit && exit->z < depth)
                least = std::min(least, std::hypot(exit->x - i, map.texelAspect * (exit->y - j)) /
                                            (depth - exit->z));
        }
    return least;
}

}  // namespace

textures::Plane buildRelaxedConesByRays(const textures::DepthMap& map, int steps,
                                        const std::function<void(std::size_t)>& advance) {
    assert(steps >= 1);
    textures::Plane ratio(map.width(), map.height());
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int i = 0; i < map.width(); ++i)
            ratio.at(i, j) = roundDown(belowRounding(leastRatio(map, i, j, steps) / map.width()));
        if (advance)
            advance(static_cast<std::size_t>(map.width()));
    });
    return ratio;
}

}  // namespace relievo::preprocess
