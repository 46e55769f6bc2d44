#include "solids/part_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "solids/solid_tracer.h"

namespace relievo::solids {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthestTexel = 0x1p51;

struct Box {
    glm::dvec3 low;
    glm::dvec3 high;

    [[nodiscard]] bool isEmpty() const {
        return low.x > high.x || low.y > high.y || low.z > high.z;
    }
};

Box windowOf(const SolidPart& part) {
    Box box{part.windowMinimum, part.windowMaximum};
    if (part.solid.kind == SolidKind::Extrusion) {
        box.low.z = std::max(box.low.z, 0.0);
        box.high.z = std::min(box.high.z, 1.0);
    }
    return box;
}

bool isWithoutVolume(const Box& box) {
    return !(box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z);
}

// What a bound of the distance in tile space takes: the metric, and how long a unit of v is.
struct Scale {
    const TileMetric& metric;
    double rowScale;

    [[nodiscard]] double toBox(const Box& box, const glm::dvec3& p) const {
        const glm::dvec3 away = glm::max(glm::max(box.low - p, p - box.high), glm::dvec3(0.0));
        const glm::dvec3 planes = away * metric.slab;
        return std::max(
            {planes.x, planes.y, planes.z,
             std::hypot(metric.horizontal * away.x, metric.horizontal * rowScale * away.y,
                        metric.vertical * away.z)});
    }
    // From a point inside to what is outside; 0 from outside.
    [[nodiscard]] double outOfBox(const Box& box, const glm::dvec3& p) const {
        const glm::dvec3 depth =
            glm::max(glm::min(p - box.low, box.high - p), glm::dvec3(0.0)) * metric.slab;
        return std::min({depth.x, depth.y, depth.z});
    }
};

// c(ζ) = clear + slope·ζ: how clear d is of the offset at a height of ζ above or below the place.
struct Clearance {
    double clear = 0.0;  // tile widths
    double slope = 0.0;  // per unit of z
    double low = 0.0;    // ζ of the piece
    double high = 0.0;
};

// The least distance at which d can have used up its clearance: the minimum over ζ of
// vertical²·ζ² + horizontal²·reach²(c(ζ)), which is convex, in closed form for each of the bounds
// of the reach.
double leastDistance(const Clearance& c, double distance, const FreeSpace& freeSpace,
                     const TileMetric& metric) {
    const double texel = metric.horizontal / freeSpace.texels();
    const double upright = metric.vertical * metric.vertical;
    double square = 0.0;
    for (const ReachTerm& term : freeSpace.terms(distance)) {
        const double level = term.factor * texel * texel;
        const double sure = c.clear * freeSpace.texels() - term.uncertainty;
        const double slope = c.slope * freeSpace.texels();
        const double weight = upright + level * slope * slope;
        const double free = sure > 0.0 && weight > 0.0 ? -level * slope * sure / weight : 0.0;
        const double height = std::clamp(free, c.low, c.high);
        const double left = std::max(0.0, sure + slope * height);
        square = std::max(
            square, upright * height * height + level * left * left - term.less * texel * texel);
    }
    return std::sqrt(square);
}

// Of {±(d − o(z)) ≤ 0} for z within the box, from one place.
double toProfile(const SolidPart& part, const FreeSpace& freeSpace, const TileMetric& metric,
                 const Box& box, const glm::dvec3& p, double distance, double sign) {
    double nearest = kInfinity;
    for (const ProfilePiece& piece : part.solid.profile.pieces) {
        const double low = std::max(piece.top, box.low.z);
        const double high = std::min(piece.bottom, box.high.z);
        if (low > high)
            continue;
        const Clearance clearance{sign * (distance - piece.offset(p.z)), -sign * piece.slope(),
                                  low - p.z, high - p.z};
        nearest = std::min(nearest, leastDistance(clearance, distance, freeSpace, metric));
    }
    return nearest;
}

DistanceBounds extrusionBounds(const SolidPart& part, const FreeSpace& freeSpace,
                               const TileMetric& metric, const glm::dvec3& p) {
    const Box box = windowOf(part);
    const Scale scale{metric, part.solid.shape->aspect()};
    const double step = stepAt(part.solid, p);
    return {std::max(scale.toBox(box, p), toProfile(part, freeSpace, metric, box, p, step, 1.0)),
            std::min(scale.outOfBox(box, p), toProfile(part, freeSpace, metric, box, p,
                                                       step + freeSpace.creaseDepth(), -1.0))};
}

// To what is beyond the 3×3×3 replicas around `centre`, of the window.
double beyondNeighbours(const Box& box, const glm::dvec3& centre, const TileMetric& metric,
                        const glm::dvec3& p) {
    double nearest = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        if (box.low[axis] < centre[axis] - 1.0)
            nearest = std::min(nearest, metric.slab[axis] * (p[axis] - (centre[axis] - 1.0)));
        if (box.high[axis] > centre[axis] + 2.0)
            nearest = std::min(nearest, metric.slab[axis] * (centre[axis] + 2.0 - p[axis]));
    }
    return std::max(0.0, nearest);
}

DistanceBounds revolutionBounds(const SolidPart& part, const FreeSpace& freeSpace,
                                const TileMetric& metric, const glm::dvec3& p) {
    const Box box = windowOf(part);
    const Scale scale{metric, 1.0};
    // A texel of the section in the world, whichever way it lies.
    const double texel = std::min(metric.horizontal, metric.vertical / part.solid.shape->aspect()) /
                         freeSpace.texels();
    const glm::dvec3 centre = glm::floor(glm::clamp(p, box.low, box.high));
    const double beyond = beyondNeighbours(box, centre, metric, p);
    DistanceBounds bounds{beyond, std::min(beyond, scale.outOfBox(box, p))};
    for (int k = 0; k < 27; ++k) {
        const glm::dvec3 tile = centre + glm::dvec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        const Box replica{glm::max(box.low, tile), glm::min(box.high, tile + 1.0)};
        if (isWithoutVolume(replica) && !isWithoutVolume(box))
            continue;  // it touches the window from outside
        const double away = scale.toBox(replica, p);
        const double step = sectionStep(part.solid, tile, p);
        const double extension = part.solid.extension;
        const double clear = std::max(away, texel * freeSpace.radius(step, extension, extension));
        bounds.toSolid = std::min(bounds.toSolid, step > extension ? clear : away);
        bounds.toOutside = std::min(bounds.toOutside, step > extension ? away : clear);
    }
    bounds.toSolid = std::max(bounds.toSolid, scale.toBox(box, p));
    return bounds;
}

}  // namespace

DistanceBounds partBounds(const SolidPart& part, const FreeSpace& freeSpace,
                          const TileMetric& metric, const glm::dvec3& place) {
    const Box box = windowOf(part);
    if (box.isEmpty())
        return {kInfinity, 0.0};
    const double size = std::max(part.solid.shape->width(), part.solid.shape->height());
    const glm::dvec3 texels = glm::abs(place) * size;
    if (!(std::max({texels.x, texels.y, texels.z}) < kFarthestTexel))  // or not a number
        return {std::max(0.0, Scale{metric, 1.0}.toBox(box, place)), 0.0};
    return part.solid.kind == SolidKind::Extrusion
               ? extrusionBounds(part, freeSpace, metric, place)
               : revolutionBounds(part, freeSpace, metric, place);
}

}  // namespace relievo::solids
