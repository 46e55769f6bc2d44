#include "creased_distance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace relievo::preprocess {
namespace {

using reference::OutlineContour;
using reference::PlaneOutline;

constexpr double kSideReach = 24.0;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

struct Corner {
    glm::dvec2 place;
    bool isConvex;
    double reach;  // of the samples that it changes
    OutlineSide first;
    OutlineSide second;
};

std::vector<Corner> sidesOf(const std::vector<OutlineContour>& contours,
                            const std::vector<OutlineCorner>& places, const PlaneOutline& outline) {
    std::vector<Corner> corners;
    std::size_t number = 0;
    std::size_t contour = std::numeric_limits<std::size_t>::max();
    for (const OutlineCorner& at : places) {
        number = at.contour == contour ? number + 1 : 0;
        contour = at.contour;
        const OutlineContour& points = contours[contour];
        // Just beside the middle of the segment that leaves the corner.
        const glm::dvec2 end = points[(at.vertex + 1) % points.size()];
        const glm::dvec2 along = end - at.place;
        const glm::dvec2 left(-along.y, along.x);
        const bool isInsideLeft = outline.isInside(at.place + 0.5 * along + 1e-4 * left);
        OutlineSide behind(points, at.vertex, 1, kSideReach, isInsideLeft);
        OutlineSide before(points, at.vertex, -1, kSideReach, !isInsideLeft);
        const glm::dvec2 in = -before.direction();
        const bool turnsLeft = cross(in, behind.direction()) > 0.0;
        const double turn = std::acos(std::clamp(glm::dot(in, behind.direction()), -1.0, 1.0));
        // Samples of cells on one side that are nearer to the other one.
        const double half = 0.5 * (std::numbers::pi - turn);
        const double reach = std::min(1.5 + 1.5 / std::tan(half), 12.0);
        // Along the contour sides are the first and the second of their corners in turn, so that
        // each is the same one at both of its ends.
        if (number % 2 == 0)
            corners.push_back({at.place, turnsLeft == isInsideLeft, reach, before, behind});
        else
            corners.push_back({at.place, turnsLeft == isInsideLeft, reach, behind, before});
    }
    return corners;
}

// What a corner makes of a sample.
struct Crease {
    double value;  // f
    double e;
};

Crease creaseAt(const Corner& corner, const glm::dvec2& place) {
    const double a = corner.first.distance(place);
    const double b = corner.second.distance(place);
    if (corner.isConvex)
        return {std::max(a, b), std::clamp(b - a, -kCreaseLimit, kCreaseLimit)};
    return {std::min(a, b), std::clamp(kCreaseLimit + b - a, 0.0, 2.0 * kCreaseLimit)};
}

// A sample that a corner changes.
struct CreasedSample {
    int i;
    int j;
    double share;  // how far away from the corner, of its reach
    Crease crease;
};

// Whether a cell around the sample has the outline in it, as the corner alone would have it.
bool isNeeded(const Corner& corner, int i, int j) {
    for (const int y : {j, j + 1})
        for (const int x : {i, i + 1})
            if (std::abs(creaseAt(corner, glm::dvec2(x, y)).value) < 0.7072)
                return true;
    return false;
}

// Nothing else is near: on the side where the corner is sharp distances are those of the two sides,
// and on the other they are nowhere smaller.
bool agrees(const Corner& corner, double value, double distance) {
    constexpr double kTolerance = 0.05;
    const double sign = corner.isConvex ? 1.0 : -1.0;
    const double difference = sign * (value - distance);
    return difference < kTolerance &&
           (sign * distance < 0.0 ? difference > -kTolerance : sign * value > -kTolerance);
}

// The samples that a corner changes; none where something else is too near.
std::vector<CreasedSample> samplesOf(const Corner& corner, const textures::Plane& exact) {
    const int reach = static_cast<int>(std::ceil(corner.reach));
    const int x = static_cast<int>(std::floor(corner.place.x));
    const int y = static_cast<int>(std::floor(corner.place.y));
    std::vector<CreasedSample> samples;
    for (int j = std::max(0, y - reach); j <= std::min(exact.height - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(exact.width - 1, x + reach); ++i) {
            const glm::dvec2 place(i + 0.5, j + 0.5);
            const double share = glm::distance(place, corner.place) / corner.reach;
            if (share >= 1.0 || !isNeeded(corner, i, j))
                continue;
            const Crease crease = creaseAt(corner, place);
            if (!agrees(corner, crease.value, exact.at(i, j)))
                return {};
            samples.push_back({i, j, share, crease});
        }
    return samples;
}

// Around creases where e crosses K other samples must have e = K, which leaves their f as it is.
int raiseAround(const textures::Plane& share, SampledDistance& field) {
    const auto limit = static_cast<float>(kCreaseLimit);
    const textures::Plane crease = field.crease;
    int conflicts = 0;
    for (int j = 0; j < crease.height; ++j)
        for (int i = 0; i < crease.width; ++i) {
            if (share.at(i, j) < 1.0f)
                continue;
            bool isBelow = false;
            bool isAbove = false;
            for (int y = std::max(0, j - 1); y <= std::min(crease.height - 1, j + 1); ++y)
                for (int x = std::max(0, i - 1); x <= std::min(crease.width - 1, i + 1); ++x) {
                    isBelow = isBelow || crease.at(x, y) < 0.0f;
                    isAbove = isAbove || crease.at(x, y) > limit;
                }
            conflicts += isBelow && isAbove ? 1 : 0;
            if (!isAbove || isBelow)
                continue;
            field.crease.at(i, j) = limit;
            field.distance.at(i, j) -= limit;
        }
    return conflicts;
}

}  // namespace

OutlineSide::OutlineSide(const OutlineContour& contour, std::size_t corner, int step, double reach,
                         bool isInsideLeft)
    : points_{contour[corner], contour[corner]}, sign_(isInsideLeft ? -1.0 : 1.0) {
    const auto size = static_cast<std::ptrdiff_t>(contour.size());
    auto number = static_cast<std::ptrdiff_t>(corner);
    double length = 0.0;
    const double most = std::cos(5.0 * std::numbers::pi / 180.0);
    while (length < reach) {
        number = (number + step + size) % size;
        const glm::dvec2 point = contour[static_cast<std::size_t>(number)];
        const glm::dvec2 along = point - points_.back();
        if (points_.size() > 2) {
            const glm::dvec2 before = points_.back() - points_[points_.size() - 2];
            if (glm::dot(before, along) < most * glm::length(before) * glm::length(along))
                break;
        }
        length += glm::length(along);
        points_.push_back(point);
    }
    points_[0] -= 100.0 * direction();
    points_.push_back(points_.back() +
                      100.0 * glm::normalize(points_.back() - points_[points_.size() - 2]));
}

glm::dvec2 OutlineSide::direction() const {
    return glm::normalize(points_[2] - points_[1]);
}

double OutlineSide::distance(const glm::dvec2& place) const {
    double nearest = std::numeric_limits<double>::infinity();
    double result = 0.0;
    for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
        const glm::dvec2 along = points_[k + 1] - points_[k];
        const glm::dvec2 off = place - points_[k];
        const double share = std::clamp(glm::dot(off, along) / glm::dot(along, along), 0.0, 1.0);
        const double distance = glm::length(off - share * along);
        if (distance >= nearest)
            continue;
        nearest = distance;
        result = std::copysign(distance, cross(along, off)) * sign_;
    }
    return result;
}

SampledDistance sampleDistance(const textures::Plane& exact,
                               const std::vector<OutlineContour>& contours,
                               const std::vector<OutlineCorner>& corners,
                               const PlaneOutline& outline, CornerMethod method,
                               CreaseStatistics* statistics) {
    SampledDistance field{exact, {}, kCreaseLimit};
    if (method == CornerMethod::Plain)
        return field;
    CreaseStatistics counted;
    field.crease = textures::Plane(exact.width, exact.height);
    // Of two corners the one changes a sample that it is the nearer to.
    textures::Plane share(exact.width, exact.height, 1.0f);
    for (const Corner& corner : sidesOf(contours, corners, outline)) {
        const std::vector<CreasedSample> samples = samplesOf(corner, exact);
        ++(samples.empty() ? counted.dropped : counted.corners);
        for (const CreasedSample& sample : samples) {
            if (sample.share >= share.at(sample.i, sample.j))
                continue;
            share.at(sample.i, sample.j) = static_cast<float>(sample.share);
            const double e = method == CornerMethod::Creased ? sample.crease.e : 0.0;
            field.crease.at(sample.i, sample.j) = static_cast<float>(e);
            field.distance.at(sample.i, sample.j) =
                static_cast<float>(sample.crease.value - std::clamp(e, 0.0, kCreaseLimit));
        }
    }
    counted.samples = static_cast<int>(
        std::count_if(share.texels.begin(), share.texels.end(), [](float s) { return s < 1.0f; }));
    counted.conflicts = raiseAround(share, field);
    if (statistics != nullptr)
        *statistics = counted;
    return field;
}

}  // namespace relievo::preprocess
