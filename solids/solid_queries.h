#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "solids/part_bounds.h"
#include "solids/solid_tracer.h"
#include "solids/tile_metric.h"

namespace relievo::solids {

/// Where a ray of the world meets a placed whole.
struct WorldHit {
    double t = 0.0;
    glm::dvec3 position{0.0};  ///< in the world
    /// Of unit length, out of what is solid; 0 where the ray begins inside.
    glm::dvec3 normal{0.0};
    SolidHit hit;  ///< in the space of the whole
};

/// The place of a whole that is nearest to a point, within a tolerance.
struct NearestPlace {
    /// Never more than the true distance.
    double distance = 0.0;
    /// A place at most the tolerance further away, which is solid or is so near to what is that the
    /// bounds can not tell them apart within the tolerance. The point itself where it is inside, or
    /// where nothing is found.
    glm::dvec3 position{0.0};
    bool isFound = false;
    /// No: the search took more boxes than it may. The distance is a lower bound even then.
    bool isCertain = true;
};

/// The first contact of a moving sphere.
struct SphereContact {
    double t = 0.0;            ///< of the way from a to b, in [0,1]
    glm::dvec3 centre{0.0};    ///< of the sphere then
    glm::dvec3 position{0.0};  ///< where it touches, within the tolerance
    glm::dvec3 normal{0.0};  ///< from there to the centre, of unit length; 0 where the centre is in
    bool startsInContact = false;  ///< at t = 0 already
    /// No: the search for the nearest place took too many boxes there, or the advances were too
    /// many (a sphere that slides along a surface just over the tolerance away).
    bool isCertain = true;
};

/// Questions about a whole that is placed in the world: on the same maps, and so about the same
/// solid, that shaders draw. All lengths, points and normals are of the world; the placement may
/// scale, lean and mirror. Cheap to make: one for each placement.
class SolidQueries {
  public:
    /// `tracer` must outlive the queries. Throws textures::InputError where the placement, or that
    /// of a part in the whole, is not affine, finite and invertible.
    SolidQueries(const SolidTracer& tracer, const glm::dmat4& worldFromWhole);

    [[nodiscard]] bool inside(const glm::dvec3& point) const;

    /// Proven lower bounds of the distances to what is solid and to what is not. Each is 0 where
    /// nothing can be said. For single solids of distance maps toSolid is the distance itself in
    /// front of a wall, and within about half a texel of it from afar; a composed whole has the
    /// bound that its operations give.
    [[nodiscard]] DistanceBounds distanceBounds(const glm::dvec3& point) const;
    /// Their toSolid: no solid is nearer.
    [[nodiscard]] double distanceBound(const glm::dvec3& point) const {
        return distanceBounds(point).toSolid;
    }

    /// The nearest place of the whole, as long as it is within `limit` (finite); not found, and at
    /// a distance of `limit`, if none is. `tolerance` > 0. Halves boxes around the point, nearest
    /// first, and drops those that the bounds show to be free.
    [[nodiscard]] NearestPlace nearest(const glm::dvec3& point, double tolerance,
                                       double limit) const;

    /// The first hit of origin + t·direction, 0 ≤ t ≤ end.
    [[nodiscard]] std::optional<WorldHit> rayHit(const SolidRay& ray) const;

    /// The first contact of a sphere of `radius` ≥ 0 whose centre moves from a to b; nothing if it
    /// gets there. Never later than the true contact: the sphere advances only by what is proven to
    /// be free (conservative advancement), and so tunnels through nothing. At the reported one,
    /// where it isCertain, there is a place no further than radius + `tolerance` (> 0) from the
    /// centre that is solid or, within half the tolerance, not to be told from what is. Nothing for
    /// numbers that are not finite, a radius below 0 or a tolerance that is not above it.
    [[nodiscard]] std::optional<SphereContact> sweepSphere(const glm::dvec3& a, const glm::dvec3& b,
                                                           double radius, double tolerance) const;

  private:
    [[nodiscard]] std::optional<glm::dvec3> solidAhead(const glm::dvec3& point, double reach) const;

    struct PlacedPart {
        glm::dmat4 fromWorld;
        TileMetric metric;
    };

    const SolidTracer* tracer_;
    glm::dmat4 worldFromWhole_;
    glm::dmat4 wholeFromWorld_;
    std::vector<PlacedPart> parts_;
};

}  // namespace relievo::solids
