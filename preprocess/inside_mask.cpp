#include "preprocess/inside_mask.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace relievo::preprocess {
namespace {

// For each row, where its centres cross edges. An edge counts from its upper end on and up to its
// lower one, so that a row through a corner crosses one of the two edges that meet there, or both
// or none where they lie to the same side.
std::vector<std::vector<double>> crossings(const PlaneShape& shape, int height) {
    std::vector<std::vector<double>> rows(static_cast<std::size_t>(height));
    for (const BoundarySegment& edge : shape.edges) {
        const bool isDown = edge.start.y <= edge.end.y;
        const glm::dvec2& upper = isDown ? edge.start : edge.end;
        const glm::dvec2& lower = isDown ? edge.end : edge.start;
        const double first = std::clamp(std::ceil(upper.y - 0.5), 0.0, static_cast<double>(height));
        const double last = std::clamp(std::ceil(lower.y - 0.5), 0.0, static_cast<double>(height));
        for (auto row = static_cast<std::size_t>(first); row < static_cast<std::size_t>(last);
             ++row) {
            const double share = (static_cast<double>(row) + 0.5 - upper.y) / (lower.y - upper.y);
            rows[row].push_back(upper.x + share * (lower.x - upper.x));
        }
    }
    return rows;
}

void fillRow(std::vector<double>& crossings, int width, std::uint8_t* mask) {
    std::ranges::sort(crossings);
    const auto firstBehind = [width](double place) {
        return static_cast<int>(
            std::clamp(std::ceil(place - 0.5), 0.0, static_cast<double>(width)));
    };
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        std::fill(mask + firstBehind(crossings[k]), mask + firstBehind(crossings[k + 1]),
                  std::uint8_t{1});
}

}  // namespace

std::vector<std::uint8_t> insideMask(const PlaneShape& shape, int width, int height) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
    std::vector<std::vector<double>> rows = crossings(shape, height);
    tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t row) {
        fillRow(rows[row], width, mask.data() + row * static_cast<std::size_t>(width));
    });
    return mask;
}

}  // namespace relievo::preprocess
