#include "preprocess/coverage_boundary.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "preprocess/boundary_reach.h"
#include "preprocess/coverage_corners.h"
#include "preprocess/coverage_outline.h"
#include "preprocess/texel_sides.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

constexpr double kTolerance = 0.01;  // texels that points may lie beside a segment
constexpr int kMostPoints = 64;      // that one segment stands for

double distanceFromLine(const glm::dvec2& start, const glm::dvec2& end, const glm::dvec2& place) {
    const glm::dvec2 along = end - start;
    const glm::dvec2 to = place - start;
    const double length = glm::length(along);
    return length > 0.0 ? std::abs(along.x * to.y - along.y * to.x) / length : glm::length(to);
}

bool isNearCentre(const glm::dvec2& place) {
    const glm::dvec2 offset = glm::abs(glm::fract(place) - 0.5);
    return std::max(offset.x, offset.y) < 3.0 * kTolerance;
}

// A chain by as few segments as keep its points within the tolerance.
class Simplifier {
  public:
    Simplifier(const OutlineChain& chain, const TexelSides& sides,
               std::vector<std::size_t>& changed)
        : sides_(sides), changed_(changed) {
        places_.reserve(chain.points.size() + 1);
        for (const OutlinePoint& point : chain.points)
            places_.push_back(point.place);
        if (chain.isClosed)
            places_.push_back(chain.points.front().place + chain.period);
    }

    [[nodiscard]] std::vector<BoundarySegment> simplify() {
        std::vector<BoundarySegment> segments;
        for (std::size_t start = 0; start + 1 < places_.size();) {
            std::size_t end = start + 1;
            while (end + 1 < places_.size() && end - start < kMostPoints &&
                   isStraight(start, end + 1))
                ++end;
            keepSides(start, end);
            if (places_[start] != places_[end])
                segments.push_back({places_[start], places_[end]});
            start = end;
        }
        return segments;
    }

  private:
    [[nodiscard]] bool isStraight(std::size_t start, std::size_t end) const {
        for (std::size_t k = start + 1; k < end; ++k)
            if (distanceFromLine(places_[start], places_[end], places_[k]) > kTolerance)
                return false;
        return true;
    }

    // A centre may lie between the segment and the points that it stands for.
    void keepSides(std::size_t start, std::size_t end) {
        const auto first = places_.begin() + static_cast<std::ptrdiff_t>(start);
        const auto last = places_.begin() + static_cast<std::ptrdiff_t>(end);
        if (end > start + 1 && std::any_of(first + 1, last, isNearCentre))
            sides_.appendWithin(std::span(first, last + 1), changed_);
    }

    std::vector<glm::dvec2> places_;
    const TexelSides& sides_;
    std::vector<std::size_t>& changed_;
};

// The segments of a repeated tile, wherever they are, with all their copies that count in it.
std::vector<BoundarySegment> withCopies(const std::vector<BoundarySegment>& segments,
                                        const glm::dvec2& size) {
    const double reach =
        boundaryReach(segments, static_cast<int>(size.x), static_cast<int>(size.y));
    std::vector<BoundarySegment> copies;
    for (const BoundarySegment& segment : segments) {
        const glm::dvec2 least = glm::min(segment.start, segment.end);
        const glm::dvec2 most = glm::max(segment.start, segment.end);
        // Tiles k with most + k·size ≥ −reach and least + k·size ≤ size + reach.
        const glm::ivec2 first(glm::ceil((-reach - most) / size));
        const glm::ivec2 last(glm::floor((size + reach - least) / size));
        for (int j = first.y; j <= last.y; ++j)
            for (int i = first.x; i <= last.x; ++i) {
                const glm::dvec2 shift = glm::dvec2(i, j) * size;
                copies.push_back({segment.start + shift, segment.end + shift});
            }
    }
    return copies;
}

}  // namespace

CoverageBoundary coverageBoundary(const Plane& coverage, WrapMode wrap) {
    TexelSides sides(coverage, wrap);
    std::vector<OutlineChain> chains = traceCoverage(coverage, sides);
    struct Part {
        std::vector<BoundarySegment> segments;
        std::vector<std::size_t> changed;  // texels whose centres are on the other side now
    };
    std::vector<Part> parts(chains.size());
    tbb::parallel_for(std::size_t{0}, chains.size(), [&](std::size_t k) {
        sharpenCorners(coverage, sides, chains[k], parts[k].changed);
        parts[k].segments = Simplifier(chains[k], sides, parts[k].changed).simplify();
    });
    CoverageBoundary boundary;
    for (const auto& [segments, changed] : parts) {
        boundary.segments.insert(boundary.segments.end(), segments.begin(), segments.end());
        sides.flip(changed);
    }
    if (wrap == WrapMode::Repeat)
        boundary.segments = withCopies(boundary.segments, {coverage.width, coverage.height});
    boundary.inside = std::move(sides.inside);
    return boundary;
}

}  // namespace relievo::preprocess
