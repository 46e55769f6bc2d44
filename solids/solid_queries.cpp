#include "solids/solid_queries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <queue>

#include "textures/input_error.h"

namespace relievo::solids {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Boxes that a search for the nearest place looks at.
constexpr int kMostBoxes = 100000;
// Radii within which an uncertain contact looks for its place.
constexpr double kFarAhead = 4.0;
// Advances of a sphere.
constexpr int kMostSteps = 100000;

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::dvec3 transformed(const glm::dmat4& m, const glm::dvec3& point) {
    return glm::dvec3(m * glm::dvec4(point, 1.0));
}

bool isInvertible(const glm::dmat4& m) {
    const glm::dmat4 inverse = glm::affineInverse(m);
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row)
            if (!std::isfinite(m[column][row]) || !std::isfinite(inverse[column][row]))
                return false;
        if (!(std::abs(m[column][3] - (column < 3 ? 0.0 : 1.0)) <= 1e-9))
            return false;
    }
    return true;
}

// The bounds of ((first ∘ second) ∘ third) …, of those of what is on the two sides.
DistanceBounds joined(const DistanceBounds& whole, const DistanceBounds& part,
                      BooleanOperation operation) {
    switch (operation) {
        case BooleanOperation::Union:
            return {std::min(whole.toSolid, part.toSolid),
                    std::max(whole.toOutside, part.toOutside)};
        case BooleanOperation::Intersection:
            return {std::max(whole.toSolid, part.toSolid),
                    std::min(whole.toOutside, part.toOutside)};
        case BooleanOperation::Difference:
            break;
    }
    return {std::max(whole.toSolid, part.toOutside), std::min(whole.toOutside, part.toSolid)};
}

// A cube that may hold something solid.
struct Cube {
    glm::dvec3 centre;
    double half;      // of its edge
    double distance;  // of its nearest place from the point

    bool operator<(const Cube& other) const { return distance > other.distance; }
};

double distanceToCube(const glm::dvec3& point, const glm::dvec3& centre, double half) {
    return glm::length(glm::max(glm::abs(point - centre) - half, glm::dvec3(0.0)));
}

}  // namespace

SolidQueries::SolidQueries(const SolidTracer& tracer, const glm::dmat4& worldFromWhole)
    : tracer_(&tracer), worldFromWhole_(worldFromWhole) {
    if (!isInvertible(worldFromWhole))
        throw textures::InputError(
            "the placement of a solid in the world: expected an affine, invertible matrix");
    wholeFromWorld_ = glm::affineInverse(worldFromWhole);
    for (const SolidPart& part : tracer.compound().parts) {
        if (!isInvertible(part.fromWhole))
            throw textures::InputError(
                fmt::format("the placement of part {} of a solid: expected an affine, invertible "
                            "matrix",
                            parts_.size()));
        const glm::dmat4 fromWorld = part.fromWhole * wholeFromWorld_;
        const double rowScale =
            part.solid.kind == SolidKind::Extrusion ? part.solid.shape->aspect() : 1.0;
        parts_.push_back({fromWorld, tileMetric(glm::inverse(glm::dmat3(fromWorld)), rowScale)});
    }
}

bool SolidQueries::inside(const glm::dvec3& point) const {
    return tracer_->contains(transformed(wholeFromWorld_, point));
}

DistanceBounds SolidQueries::distanceBounds(const glm::dvec3& point) const {
    DistanceBounds whole{kInfinity, 0.0};
    if (!isFinite(point))
        return {0.0, 0.0};
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const SolidPart& part = tracer_->compound().parts[k];
        const DistanceBounds bounds = partBounds(part, tracer_->freeSpace(k), parts_[k].metric,
                                                 transformed(parts_[k].fromWorld, point));
        whole = joined(whole, bounds, part.operation);
    }
    return whole;
}

NearestPlace SolidQueries::nearest(const glm::dvec3& point, double tolerance, double limit) const {
    if (!isFinite(point) || !(tolerance > 0.0) || !(limit >= 0.0) || !std::isfinite(limit))
        return {0.0, point, false, false};
    if (inside(point))
        return {0.0, point, true, true};
    NearestPlace place{limit, point, false, true};
    if (const auto ahead = solidAhead(point, limit))
        place = {glm::distance(point, *ahead), *ahead, true, true};
    std::priority_queue<Cube> cubes;
    cubes.push({point, limit, 0.0});
    for (int k = 0; k < kMostBoxes; ++k) {
        // place.distance is that of the nearest place known to be solid, or the limit.
        if (cubes.empty() || cubes.top().distance >= place.distance)
            return place;
        const Cube cube = cubes.top();
        cubes.pop();
        if (distanceBound(cube.centre) > std::sqrt(3.0) * cube.half)
            continue;
        const double away = glm::distance(point, cube.centre);
        if (away <= place.distance && inside(cube.centre))
            place = {away, cube.centre, true, true};
        if (place.isFound && place.distance - cube.distance <= tolerance)
            return {cube.distance, place.position, true, true};
        if (cube.half <= 0.25 * tolerance)  // of a diagonal under the tolerance
            return {cube.distance, cube.centre, true, true};
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 side((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                                  (corner & 4) != 0 ? 0.5 : -0.5);
            const glm::dvec3 centre = cube.centre + cube.half * side;
            const double distance = distanceToCube(point, centre, 0.5 * cube.half);
            if (distance < place.distance)
                cubes.push({centre, 0.5 * cube.half, distance});
        }
    }
    if (!cubes.empty())
        place.distance = std::min(place.distance, cubes.top().distance);
    place.isCertain = false;
    return place;
}

std::optional<WorldHit> SolidQueries::rayHit(const SolidRay& ray) const {
    const SolidRay inWhole{transformed(wholeFromWorld_, ray.origin),
                           glm::dmat3(wholeFromWorld_) * ray.direction, ray.end};
    const std::optional<SolidHit> hit = tracer_->firstHit(inWhole);
    if (!hit)
        return std::nullopt;
    const glm::dvec3 normal = glm::transpose(glm::dmat3(wholeFromWorld_)) * hit->outward;
    const double length = glm::length(normal);
    return WorldHit{hit->t, ray.origin + hit->t * ray.direction,
                    length > 0.0 ? normal / length : glm::dvec3(0.0), *hit};
}

// A solid place at most `reach` from a point, straight on in the direction in which the bound
// falls.
std::optional<glm::dvec3> SolidQueries::solidAhead(const glm::dvec3& point, double reach) const {
    const double shift = std::max(1e-3 * distanceBound(point), 1e-9 * reach);
    glm::dvec3 downhill(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 aside(0.0);
        aside[axis] = shift;
        downhill[axis] = distanceBound(point - aside) - distanceBound(point + aside);
    }
    const double length = glm::length(downhill);
    if (!(length > 0.0) || !std::isfinite(length))
        return std::nullopt;
    const std::optional<WorldHit> hit = rayHit({point, downhill / length, reach});
    return hit ? std::optional(hit->position) : std::nullopt;
}

std::optional<SphereContact> SolidQueries::sweepSphere(const glm::dvec3& a, const glm::dvec3& b,
                                                       double radius, double tolerance) const {
    if (!isFinite(a) || !isFinite(b) || !(radius >= 0.0) || !std::isfinite(radius) ||
        !(tolerance > 0.0))
        return std::nullopt;
    const double way = glm::distance(a, b);
    double t = 0.0;
    for (int step = 0;; ++step) {
        const glm::dvec3 centre = a + t * (b - a);
        const auto contact = [&](const glm::dvec3& position, bool isCertain = true) {
            const glm::dvec3 away = centre - position;
            const double length = glm::length(away);
            return SphereContact{t,        centre,   position, length > 0.0 ? away / length : away,
                                 t == 0.0, isCertain};
        };
        double free = distanceBound(centre);
        // Half of the tolerance for how near is near enough, half for not knowing how near it is.
        if (!(free > radius + 0.5 * tolerance)) {
            if (inside(centre))
                return contact(centre);
            if (const auto position = solidAhead(centre, radius + tolerance))
                return contact(*position);
            const NearestPlace place = nearest(centre, 0.5 * tolerance, radius + 4.0 * tolerance);
            free = std::max(free, place.distance);
            if (!(free > radius + 0.5 * tolerance))
                return place.isCertain
                           ? contact(place.position)
                           : contact(
                                 solidAhead(centre, kFarAhead * radius).value_or(place.position),
                                 false);
        }
        if (step == kMostSteps)
            return contact(solidAhead(centre, kFarAhead * radius).value_or(centre), false);
        if (t >= 1.0)
            return std::nullopt;
        t = way > 0.0 ? std::min(1.0, t + (free - radius) / way) : 1.0;
    }
}

}  // namespace relievo::solids
