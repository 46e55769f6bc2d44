#include "solids/part_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <limits>

namespace relievo::solids {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthestTexel = 0x1p51;

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// A ray in the window of a part: parameters between which it is there, and the borders' axes.
struct Clip {
    double begin = 0.0;
    double end = kInfinity;
    int entryAxis = -1;
    int exitAxis = -1;
    glm::dvec3 start{0.0};
};

std::optional<Clip> clip(const SolidRay& ray, const glm::dvec3& low, const glm::dvec3& high) {
    Clip clipped;
    clipped.end = ray.end;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (direction == 0.0) {
            if (!(origin >= low[axis] && origin <= high[axis]))
                return std::nullopt;
            continue;
        }
        const double entry = ((direction > 0.0 ? low : high)[axis] - origin) / direction;
        const double exit = ((direction > 0.0 ? high : low)[axis] - origin) / direction;
        if (entry >= clipped.begin) {
            clipped.begin = entry;
            clipped.entryAxis = axis;
        }
        if (exit <= clipped.end && exit < kInfinity) {
            clipped.end = exit;
            clipped.exitAxis = axis;
        }
    }
    // A ray that meets the window in one point, coming from outside, does not go in.
    if (!(clipped.begin <= clipped.end) ||
        (clipped.begin == clipped.end && (clipped.begin > 0.0 || clipped.exitAxis >= 0)))
        return std::nullopt;
    clipped.start = ray.origin + clipped.begin * ray.direction;
    // On the border the coordinate is the bound itself, whatever the rounding.
    if (clipped.entryAxis >= 0)
        clipped.start[clipped.entryAxis] =
            (ray.direction[clipped.entryAxis] > 0.0 ? low : high)[clipped.entryAxis];
    return clipped;
}

// How far the ray goes in one unit of its parameter: tile widths of maxDistance.
double lengthOf(const Solid& solid, const glm::dvec3& direction) {
    const double aspect = solid.shape->aspect();
    if (solid.kind == SolidKind::Extrusion)
        return std::hypot(direction.x, aspect * direction.y);
    return std::hypot(direction.x, direction.y, aspect * direction.z);
}

bool isResolved(const Solid& solid, const glm::dvec3& start) {
    const glm::dvec3 texels =
        glm::abs(start) *
        glm::dvec3(solid.shape->width(), solid.shape->height(), solid.shape->height());
    return std::max({texels.x, texels.y, texels.z}) < kFarthestTexel;
}

}  // namespace

PartWalk::PartWalk(const SolidPart& part, const FreeSpace& freeSpace, const SolidRay& ray,
                   const TraceOptions& options, TraceCost* cost)
    : part_(&part) {
    const SolidRay local{glm::dvec3(part.fromWhole * glm::dvec4(ray.origin, 1.0)),
                         glm::dmat3(part.fromWhole) * ray.direction, ray.end};
    if (!isFinite(local.origin) || !isFinite(local.direction) || !(ray.end >= 0.0))
        return;
    glm::dvec3 low = part.windowMinimum;
    glm::dvec3 high = part.windowMaximum;
    if (part.solid.kind == SolidKind::Extrusion) {
        low.z = std::max(low.z, 0.0);
        high.z = std::min(high.z, 1.0);
    }
    const std::optional<Clip> clipped = clip(local, low, high);
    if (!clipped || !isFinite(clipped->start) || !isResolved(part.solid, clipped->start))
        return;

    // A power of two brings any length of direction to about 1 without rounding, so that squares
    // neither overflow nor vanish.
    const glm::dvec3 size = glm::abs(local.direction);
    const double longest = std::max({size.x, size.y, size.z});
    exponent_ = longest > 0.0 ? std::ilogb(longest) : 0;
    begin_ = clipped->begin;
    WalkSpan span;
    span.start = clipped->start;
    for (int axis = 0; axis < 3; ++axis)
        span.direction[axis] = std::scalbn(local.direction[axis], -exponent_);
    span.entryAxis = clipped->entryAxis;
    span.exitAxis = clipped->exitAxis;
    span.end = std::scalbn(clipped->end - clipped->begin, exponent_);
    const double length = lengthOf(part.solid, span.direction);
    if (length * span.end > options.maxDistance) {
        span.end = options.maxDistance / length;
        span.exitAxis = -1;
    }
    const FreeSpace* jumps = options.jumps ? &freeSpace : nullptr;
    if (part.solid.kind == SolidKind::Extrusion)
        walk_.emplace<ExtrusionWalk>(part.solid, jumps, span, cost);
    else
        walk_.emplace<RevolutionWalk>(part.solid, jumps, span, cost);
}

std::optional<SolidCrossing> PartWalk::next() {
    std::optional<SolidCrossing> crossing;
    if (auto* extrusion = std::get_if<ExtrusionWalk>(&walk_))
        crossing = extrusion->next();
    else if (auto* revolution = std::get_if<RevolutionWalk>(&walk_))
        crossing = revolution->next();
    if (crossing && !std::isfinite(std::scalbn(crossing->t, -exponent_)))
        return std::nullopt;  // further than doubles go
    if (crossing) {
        last_ = std::max(last_, begin_ + std::scalbn(crossing->t, -exponent_));
        crossing->t = last_;
        crossing->outward = glm::transpose(glm::dmat3(part_->fromWhole)) * crossing->outward;
    }
    return crossing;
}

}  // namespace relievo::solids
