#include "preprocess/relaxed_cones_policarpo.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
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

// Steps of index along the longer axis.
constexpr double kStep = 0.5;

// The first step outside the relief on the ray through (i,j,0) and the surface point `entry`, as
// long as it is above the bottom. A ray at depth 0 is level and meets no bottom: nothing after as
// many texels as the map has in both directions.
std::optional<Point> firstOutside(const textures::DepthMap& map, int i, int j, const Point& entry) {
    const double across = entry.x - i;
    const double down = entry.y - j;
    const double step = kStep / std::max(std::abs(across), std::abs(down));
    const int most = static_cast<int>((map.width() + map.height()) / kStep);
    for (int k = 1; k <= most; ++k) {
        const double t = k * step;
        const Point point{entry.x + t * across, entry.y + t * down, entry.z + t * entry.z};
        if (point.z > 1.0)
            break;
        if (point.z < depthAt(map, point.x, point.y))
            return point;
    }
    return std::nullopt;
}

// The least ratio of an apex, in texels per unit of depth; infinite where no ray leaves above it.
double leastRatio(const textures::DepthMap& map, int i, int j) {
    const bool repeats = map.wrap == textures::WrapMode::Repeat;
    const int left = repeats ? i - map.width() / 2 : 0;
    const int top = repeats ? j - map.height() / 2 : 0;
    const double depth = map.depth.at(i, j);
    double least = std::numeric_limits<double>::infinity();
    for (int y = top; y < top + map.height(); ++y)
        for (int x = left; x < left + map.width(); ++x) {
            const Point entry{static_cast<double>(x), static_cast<double>(y), map.at(x, y)};
            // What leaves beyond y is farther than y and not higher.
            const double nearest =
                std::hypot(entry.x - i, map.texelAspect * (entry.y - j)) / (depth - entry.z);
            if ((x == i && y == j) || entry.z >= depth || nearest >= least)
                continue;
            const std::optional<Point> exit = firstOutside(map, i, j, entry);
            if (exit && exit->z < depth)
                least = std::min(least, std::hypot(exit->x - i, map.texelAspect * (exit->y - j)) /
                                            (depth - exit->z));
        }
    return least;
}

}  // namespace

textures::Plane buildRelaxedConesByRays(const textures::DepthMap& map,
                                        const std::function<void(std::size_t)>& advance) {
    textures::Plane ratio(map.width(), map.height());
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int i = 0; i < map.width(); ++i)
            ratio.at(i, j) = roundDown(belowRounding(leastRatio(map, i, j) / map.width()));
        if (advance)
            advance(static_cast<std::size_t>(map.width()));
    });
    return ratio;
}

}  // namespace relievo::preprocess
