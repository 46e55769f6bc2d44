#include "preprocess/boundary_reach.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "preprocess/distance_transform.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {
namespace {

constexpr int kSide = 16;  // texels of a block

}  // namespace

double boundaryReach(std::span<const BoundarySegment> segments, int width, int height) {
    const double farthest = 0.5 * std::hypot(width, height);
    const int columns = (width + kSide - 1) / kSide;
    const int rows = (height + kSide - 1) / kSide;
    std::vector<std::uint8_t> blocks(static_cast<std::size_t>(columns) *
                                     static_cast<std::size_t>(rows));
    const glm::dvec2 size(width, height);
    const auto mark = [&](const glm::dvec2& place) {
        const glm::dvec2 inTile = place - size * glm::floor(place / size);
        const int i = std::clamp(static_cast<int>(inTile.x) / kSide, 0, columns - 1);
        const int j = std::clamp(static_cast<int>(inTile.y) / kSide, 0, rows - 1);
        blocks[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(i)] = 1;
    };
    for (const auto& [start, end] : segments) {
        const int count = 1 + static_cast<int>(glm::distance(start, end) / kSide);
        for (int k = 0; k < count; ++k)
            mark(glm::mix(start, end, static_cast<double>(k) / count));
    }
    const SquaredDistances squares = distancesTo(blocks, columns, rows, textures::WrapMode::Repeat);
    const std::uint32_t most = std::ranges::max(squares.texels);
    if (most == SquaredDistances::kUnlimited)
        return farthest;
    // From anywhere in a block to anywhere in another: a diagonal more than between their centres.
    return std::min(farthest, kSide * (std::sqrt(static_cast<double>(most)) + std::sqrt(2.0)));
}

bool isNearTile(const BoundarySegment& segment, const glm::dvec2& size, double reach) {
    for (int axis = 0; axis < 2; ++axis) {
        const auto [least, most] = std::minmax(segment.start[axis], segment.end[axis]);
        if (most < -reach || least > size[axis] + reach)
            return false;
    }
    return true;
}

}  // namespace relievo::preprocess
