#include "preprocess/outline_corners.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "textures/shape_map.h"

namespace relievo::preprocess {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

glm::dvec2 alongOf(const BoundarySegment& segment) {
    return segment.end - segment.start;
}

bool isTurn(const BoundarySegment& before, const BoundarySegment& behind) {
    const glm::dvec2 a = alongOf(before);
    const glm::dvec2 b = alongOf(behind);
    return glm::dot(a, b) < kCornerCosine * glm::length(a) * glm::length(b);
}

// Which segment goes on where one ends: mostly the next, but paths are closed, and parts of them
// may have been left out.
class Paths {
  public:
    explicit Paths(const std::vector<BoundarySegment>& segments)
        : segments_(segments), next_(segments.size(), kNone), before_(segments.size(), kNone) {
        for (std::size_t k = 0; k + 1 < segments.size(); ++k)
            if (segments[k].end == segments[k + 1].start)
                join(k, k + 1);
        std::map<std::pair<double, double>, std::size_t> starts;
        for (std::size_t k = 0; k < segments.size(); ++k)
            if (before_[k] == kNone)
                starts.try_emplace({segments[k].start.x, segments[k].start.y}, k);
        for (std::size_t k = 0; k < segments.size(); ++k) {
            if (next_[k] != kNone)
                continue;
            const auto found = starts.find({segments[k].end.x, segments[k].end.y});
            if (found != starts.end() && before_[found->second] == kNone)
                join(k, found->second);
        }
    }

    [[nodiscard]] std::size_t next(std::size_t k) const { return next_[k]; }
    [[nodiscard]] std::size_t before(std::size_t k) const { return before_[k]; }
    [[nodiscard]] const BoundarySegment& segment(std::size_t k) const { return segments_[k]; }
    // Whether there is a corner where segment k starts.
    [[nodiscard]] bool isCorner(std::size_t k) const {
        return before_[k] != kNone && isTurn(segments_[before_[k]], segments_[k]);
    }

  private:
    void join(std::size_t a, std::size_t b) {
        next_[a] = b;
        before_[b] = a;
    }
    const std::vector<BoundarySegment>& segments_;
    std::vector<std::size_t> next_;
    std::vector<std::size_t> before_;
};

// From segment `first`, where a corner is, to the next one.
OutlineSide sideFrom(const Paths& paths, std::size_t first, bool isBehind) {
    std::vector<BoundarySegment> segments;
    double length = 0.0;
    for (std::size_t k = first; k != kNone && length < kSideLength;) {
        segments.push_back(paths.segment(k));
        length += glm::length(alongOf(paths.segment(k)));
        const std::size_t next = isBehind ? paths.next(k) : paths.before(k);
        if (next == first || (next != kNone && paths.isCorner(isBehind ? next : k)))
            break;
        k = next;
    }
    return {std::move(segments), isBehind};
}

OutlineCorner cornerAt(const Paths& paths, std::size_t k) {
    const glm::dvec2 in = glm::normalize(alongOf(paths.segment(paths.before(k))));
    const glm::dvec2 out = glm::normalize(alongOf(paths.segment(k)));
    return {paths.segment(k).start, std::acos(std::clamp(glm::dot(in, out), -1.0, 1.0)),
            cross(in, out) > 0.0, sideFrom(paths, paths.before(k), false),
            sideFrom(paths, k, true)};
}

}  // namespace

OutlineSide::OutlineSide(std::vector<BoundarySegment> segments, bool isBehind)
    : segments_(std::move(segments)) {
    for (const BoundarySegment& segment : segments_)
        length_ += glm::length(alongOf(segment));
    // Straight on in the direction from the corner, and from it.
    const auto continuation = [&](const BoundarySegment& segment) {
        return (isBehind ? 2.0 : -2.0) * kSideLength * glm::normalize(alongOf(segment));
    };
    const glm::dvec2 near = continuation(segments_.front());
    const glm::dvec2 far = continuation(segments_.back());
    (isBehind ? segments_.front().start : segments_.front().end) -= near;
    (isBehind ? segments_.back().end : segments_.back().start) += far;
}

double OutlineSide::distance(const glm::dvec2& place) const noexcept {
    double nearest = std::numeric_limits<double>::infinity();
    double result = 0.0;
    for (const BoundarySegment& segment : segments_) {
        const glm::dvec2 along = alongOf(segment);
        const glm::dvec2 off = place - segment.start;
        const double share = std::clamp(glm::dot(off, along) / glm::dot(along, along), 0.0, 1.0);
        const glm::dvec2 away = off - share * along;
        const double square = glm::dot(away, away);
        if (square >= nearest)
            continue;
        nearest = square;
        result = -std::copysign(std::sqrt(square), cross(along, off));
    }
    return result;
}

double OutlineCorner::distance(const glm::dvec2& where) const noexcept {
    return isConvex ? std::max(toA(where), toB(where)) : std::min(toA(where), toB(where));
}

bool OutlineCorner::isOnA(const glm::dvec2& where) const noexcept {
    return (toA(where) > toB(where)) == isConvex;
}

double OutlineCorner::code(const glm::dvec2& where) const noexcept {
    const double size =
        std::abs(toA(where) - toB(where)) + (isConvex ? 0.0 : textures::kReflexTexels);
    return isOnA(where) ? -size : size;
}

// Where corners are far apart it does not matter which of their sides is A, so that each group of
// near ones is settled on its own, the same in all copies of a tile.
std::vector<OutlineCorner> outlineCorners(const std::vector<BoundarySegment>& boundary) {
    const Paths paths(boundary);
    const std::size_t count = boundary.size();
    std::vector<OutlineCorner> corners;
    std::vector<std::size_t> number(count, kNone);  // of the corner where a segment starts
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k < count; ++k)
        if (paths.isCorner(k)) {
            number[k] = corners.size();
            starts.push_back(k);
            corners.push_back(cornerAt(paths, k));
        }
    const auto nextCorner = [&](std::size_t corner) {
        std::size_t k = paths.next(starts[corner]);
        while (k != kNone && number[k] == kNone && k != starts[corner])
            k = paths.next(k);
        return k == kNone ? kNone : number[k];
    };
    std::vector<bool> isSettled(corners.size());
    const auto settleFrom = [&](std::size_t corner) {
        while (!isSettled[corner]) {
            isSettled[corner] = true;
            if (corners[corner].behind.length() > kFarApart)
                return;
            const std::size_t next = nextCorner(corner);
            if (next == kNone || isSettled[next])
                return;
            corners[next].isBehindA = !corners[corner].isBehindA;
            corner = next;
        }
    };
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
        if (corners[corner].before.length() > kFarApart)
            settleFrom(corner);
    // Small closed paths: from their first corner from above.
    std::vector<std::size_t> left;
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
        if (!isSettled[corner])
            left.push_back(corner);
    std::sort(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(corners[a].place.y, corners[a].place.x) <
               std::pair(corners[b].place.y, corners[b].place.x);
    });
    for (const std::size_t corner : left)
        settleFrom(corner);
    return corners;
}

}  // namespace relievo::preprocess
