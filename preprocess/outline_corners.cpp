#include "preprocess/outline_corners.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <unordered_map>
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

// Which segment goes on where one ends: mostly the next, but paths are closed, and parts of them
// may have been left out.
class Paths {
  public:
    // A corner is where one turns by at least `leastTurn`.
    Paths(const std::vector<BoundarySegment>& segments, double leastTurn)
        : segments_(segments),
          cosine_(std::cos(leastTurn)),
          next_(segments.size(), kNone),
          before_(segments.size(), kNone) {
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
        if (before_[k] == kNone)
            return false;
        const glm::dvec2 in = alongOf(segments_[before_[k]]);
        const glm::dvec2 out = alongOf(segments_[k]);
        return glm::dot(in, out) < cosine_ * glm::length(in) * glm::length(out);
    }
    // Whether the next corner behind segment k, or before it, is nearer than that, counted from the
    // corner at its start, or at its end.
    [[nodiscard]] bool hasCornerWithin(std::size_t k, bool isBehind, double way) const {
        for (double length = 0.0; k != kNone;) {
            length += glm::length(alongOf(segments_[k]));
            if (length >= way)
                return false;
            const std::size_t next = isBehind ? next_[k] : before_[k];
            if (next != kNone && isCorner(isBehind ? next : k))
                return true;
            k = next;
        }
        return false;
    }

  private:
    void join(std::size_t a, std::size_t b) {
        next_[a] = b;
        before_[b] = a;
    }
    const std::vector<BoundarySegment>& segments_;
    double cosine_;
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

// Where corners are far apart it does not matter which of their sides is A, so that each group of
// near ones is settled on its own, the same in all copies of a tile.
class SideLabels {
  public:
    // `starts`: the segments that begin at the corners.
    SideLabels(const Paths& paths, const std::vector<std::size_t>& starts,
               std::vector<OutlineCorner>& corners)
        : paths_(paths), starts_(starts), corners_(corners), isSettled_(corners.size()) {
        for (std::size_t corner = 0; corner < corners.size(); ++corner)
            number_[starts[corner]] = corner;
    }

    void settle() {
        for (std::size_t corner = 0; corner < corners_.size(); ++corner)
            if (corners_[corner].before.length() > kFarApart)
                settleFrom(corner);
        // Small closed paths: from their first corner from above.
        std::vector<std::size_t> left;
        for (std::size_t corner = 0; corner < corners_.size(); ++corner)
            if (!isSettled_[corner])
                left.push_back(corner);
        std::ranges::sort(left, {}, [&](std::size_t corner) {
            return std::pair(corners_[corner].place.y, corners_[corner].place.x);
        });
        for (const std::size_t corner : left)
            settleFrom(corner);
    }

  private:
    void settleFrom(std::size_t corner) {
        while (!isSettled_[corner]) {
            isSettled_[corner] = true;
            if (corners_[corner].behind.length() > kFarApart)
                return;
            const std::size_t next = nextCorner(corner);
            if (next == kNone || isSettled_[next])
                return;
            corners_[next].isBehindA = !corners_[corner].isBehindA;
            corner = next;
        }
    }
    [[nodiscard]] std::size_t nextCorner(std::size_t corner) const {
        std::size_t k = paths_.next(starts_[corner]);
        while (k != kNone && k != starts_[corner] && !number_.contains(k))
            k = paths_.next(k);
        return k == kNone ? kNone : number_.at(k);
    }

    const Paths& paths_;
    const std::vector<std::size_t>& starts_;
    std::vector<OutlineCorner>& corners_;
    std::vector<bool> isSettled_;
    std::unordered_map<std::size_t, std::size_t> number_;
};

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

SideDistances OutlineCorner::sides(const glm::dvec2& where) const noexcept {
    return isBehindA ? SideDistances{behind.distance(where), before.distance(where)}
                     : SideDistances{before.distance(where), behind.distance(where)};
}

double OutlineCorner::distance(const SideDistances& sides) const noexcept {
    return isConvex ? std::max(sides.toA, sides.toB) : std::min(sides.toA, sides.toB);
}

bool OutlineCorner::isOnA(const SideDistances& sides) const noexcept {
    return (sides.toA > sides.toB) == isConvex;
}

double OutlineCorner::code(const SideDistances& sides) const noexcept {
    const double size =
        std::abs(sides.toA - sides.toB) + (isConvex ? 0.0 : textures::kReflexTexels);
    return isOnA(sides) ? -size : size;
}

OutlineCorners outlineCorners(const std::vector<BoundarySegment>& boundary, double leastTurn) {
    const Paths paths(boundary, leastTurn);
    OutlineCorners result;
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k < boundary.size(); ++k) {
        if (!paths.isCorner(k))
            continue;
        if (paths.hasCornerWithin(k, true, kCrowded) ||
            paths.hasCornerWithin(paths.before(k), false, kCrowded)) {
            result.crowded.push_back(boundary[k].start);
            continue;
        }
        starts.push_back(k);
        result.corners.push_back(cornerAt(paths, k));
    }
    SideLabels(paths, starts, result.corners).settle();
    return result;
}

}  // namespace relievo::preprocess
