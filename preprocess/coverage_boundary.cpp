#include "preprocess/coverage_boundary.h"

#include <algorithm>
#include <glm/common.hpp>

#include "preprocess/coverage_corners.h"
#include "preprocess/coverage_outline.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

// Whether b lies exactly between a and c, on a row or a column.
bool isOnLine(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y);
}

std::vector<BoundarySegment> segmentsOf(const OutlineChain& chain) {
    std::vector<BoundarySegment> segments;
    const auto add = [&](const glm::dvec2& start, const glm::dvec2& end) {
        if (start == end)
            return;
        if (!segments.empty() && isOnLine(segments.back().start, start, end))
            segments.back().end = end;
        else
            segments.push_back({start, end});
    };
    for (std::size_t k = 0; k + 1 < chain.points.size(); ++k)
        add(chain.points[k].place, chain.points[k + 1].place);
    if (chain.isClosed)
        add(chain.points.back().place, chain.points.front().place + chain.period);
    return segments;
}

// Adds the copies of a segment that are within half a tile of the tile.
void addCopies(const BoundarySegment& segment, const glm::dvec2& size,
               std::vector<BoundarySegment>& segments) {
    const glm::dvec2 least = glm::min(segment.start, segment.end);
    const glm::dvec2 most = glm::max(segment.start, segment.end);
    // Tiles k with most + k·size ≥ −size/2 and least + k·size ≤ 3·size/2.
    const glm::ivec2 first(glm::ceil(-0.5 - most / size));
    const glm::ivec2 last(glm::floor(1.5 - least / size));
    for (int j = first.y; j <= last.y; ++j)
        for (int i = first.x; i <= last.x; ++i) {
            const glm::dvec2 shift = glm::dvec2(i, j) * size;
            segments.push_back({segment.start + shift, segment.end + shift});
        }
}

}  // namespace

CoverageBoundary coverageBoundary(const Plane& coverage, WrapMode wrap) {
    CoverageBoundary boundary;
    boundary.inside.resize(coverage.texels.size());
    std::ranges::transform(coverage.texels, boundary.inside.begin(), [](float value) {
        return value >= 0.5f ? std::uint8_t{1} : std::uint8_t{0};
    });
    std::vector<OutlineChain> chains = traceCoverage(coverage, wrap);
    sharpenCorners(coverage, wrap, chains, boundary.inside);
    const glm::dvec2 size(coverage.width, coverage.height);
    for (const OutlineChain& chain : chains)
        for (const BoundarySegment& segment : segmentsOf(chain))
            if (wrap == WrapMode::Repeat)
                addCopies(segment, size, boundary.segments);
            else
                boundary.segments.push_back(segment);
    return boundary;
}

}  // namespace relievo::preprocess
