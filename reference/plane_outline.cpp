#include "reference/plane_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace relievo::reference {
namespace {

constexpr std::uint32_t kLeafSegments = 4;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double squareToBox(const glm::dvec2& place, const PlaneOutline::Node& node) {
    const glm::dvec2 off = place - glm::clamp(place, node.low, node.high);
    return glm::dot(off, off);
}

glm::dvec2 nearestOn(const PlaneOutline::Segment& segment, const glm::dvec2& place) {
    const glm::dvec2 along = segment.end - segment.start;
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? glm::dot(place - segment.start, along) / square : 0.0;
    if (share >= 1.0)
        return segment.end;
    return segment.start + std::max(share, 0.0) * along;
}

// How often the upward line from `place` is crossed, to the right less to the left. Ends count
// with the half plane to their right, so that shared ones count once.
int turnsAt(const PlaneOutline::Segment& segment, const glm::dvec2& place) {
    const bool startsRight = segment.start.x > place.x;
    if (startsRight == (segment.end.x > place.x))
        return 0;
    const double side = cross(segment.end - segment.start, place - segment.start);
    if (startsRight)
        return side <= 0.0 ? -1 : 0;
    return side >= 0.0 ? 1 : 0;
}

}  // namespace

PlaneOutline::PlaneOutline(const std::vector<OutlineContour>& contours, Filling filling)
    : filling_(filling) {
    std::uint32_t number = 0;
    for (const OutlineContour& contour : contours)
        for (std::size_t k = 0; contour.size() >= 3 && k < contour.size(); ++k)
            segments_.push_back({contour[k], contour[(k + 1) % contour.size()], number++});
    if (!segments_.empty())
        build(0, static_cast<std::uint32_t>(segments_.size()));
}

void PlaneOutline::build(std::uint32_t first, std::uint32_t count) {
    const auto begin = segments_.begin() + first;
    const auto end = begin + count;
    Node node{begin->start, begin->start, first, count};
    for (auto segment = begin; segment != end; ++segment) {
        node.low = glm::min(node.low, glm::min(segment->start, segment->end));
        node.high = glm::max(node.high, glm::max(segment->start, segment->end));
    }
    const std::size_t number = nodes_.size();
    nodes_.push_back(node);
    if (count <= kLeafSegments)
        return;
    const glm::dvec2 size = node.high - node.low;
    const int axis = size.x >= size.y ? 0 : 1;
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, end, [axis](const Segment& a, const Segment& b) {
        return a.start[axis] + a.end[axis] < b.start[axis] + b.end[axis];
    });
    build(first, half);
    nodes_[number].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[number].count = 0;
    build(first + half, count - half);
}

bool PlaneOutline::isInside(const glm::dvec2& place) const {
    int turns = 0;
    visitSegments(
        [&](const Node& node) {
            return node.low.x <= place.x && place.x <= node.high.x && node.low.y <= place.y;
        },
        [&](const Segment& segment) { turns += turnsAt(segment, place); });
    return filling_ == Filling::NonZero ? turns != 0 : turns % 2 != 0;
}

NearestOutlinePoint PlaneOutline::nearest(const glm::dvec2& place) const {
    NearestOutlinePoint result;
    double square = std::numeric_limits<double>::infinity();
    visitSegments([&](const Node& node) { return squareToBox(place, node) < square; },
                  [&](const Segment& segment) {
                      const glm::dvec2 point = nearestOn(segment, place);
                      const glm::dvec2 off = place - point;
                      if (!(glm::dot(off, off) < square))
                          return;
                      square = glm::dot(off, off);
                      result.point = point;
                      result.segment = segment.number;
                  });
    const double distance = std::sqrt(square);
    const double sign = isInside(place) ? -1.0 : 1.0;
    result.distance = sign * distance;
    if (distance > 0.0 && !segments_.empty())
        result.direction = sign / distance * (place - result.point);
    return result;
}

std::optional<OutlineCrossing> PlaneOutline::firstCrossing(const glm::dvec2& origin,
                                                           const glm::dvec2& direction, double from,
                                                           double to) const {
    const double square = glm::dot(direction, direction);
    if (!(square > 0.0))
        return std::nullopt;
    std::optional<OutlineCrossing> found;
    double last = to;
    // The part of the ray in a box, widened by what rounding may take from it.
    const auto isReached = [&](const Node& node) {
        double enter = from;
        double leave = last;
        for (int axis = 0; axis < 2; ++axis) {
            if (direction[axis] == 0.0) {
                if (origin[axis] < node.low[axis] || origin[axis] > node.high[axis])
                    return false;
                continue;
            }
            const double a = (node.low[axis] - origin[axis]) / direction[axis];
            const double b = (node.high[axis] - origin[axis]) / direction[axis];
            const double slack = 1e-14 * (std::abs(a) + std::abs(b));
            enter = std::max(enter, std::min(a, b) - slack);
            leave = std::min(leave, std::max(a, b) + slack);
        }
        return enter <= leave;
    };
    // The side of the ray on which a point is, the same for all segments that end in it: a ray
    // slips through nowhere.
    const auto side = [&](const glm::dvec2& point) { return cross(direction, point - origin); };
    visitSegments(isReached, [&](const Segment& segment) {
        const double start = side(segment.start);
        const double end = side(segment.end);
        if ((start < 0.0) == (end < 0.0))
            return;
        const glm::dvec2 along = segment.end - segment.start;
        const glm::dvec2 point = segment.start + start / (start - end) * along;
        const double t = glm::dot(point - origin, direction) / square;
        if (!(t >= from && t <= last))
            return;
        last = t;
        glm::dvec2 normal = glm::normalize(glm::dvec2(along.y, -along.x));
        if (glm::dot(normal, direction) > 0.0)
            normal = -normal;
        found = OutlineCrossing{t, normal};
    });
    return found;
}

}  // namespace relievo::reference
