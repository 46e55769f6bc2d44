#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "solids/free_space.h"
#include "solids/solid.h"
#include "solids/solid_crossing.h"

namespace relievo::solids {

/// How solids are traced.
struct TraceOptions {
    /// Whether walks jump over space that the distance says to be free. It changes their cost and
    /// not their answer.
    bool jumps = true;
    /// Whether the shape maps hold distances, as those that relievo-bake makes do. Maps of other
    /// tools may not: what they change at most per texel is measured then, and jumps are shorter.
    bool mapsAreDistances = true;
    /// No ray is followed in the window of a part for more than this: tile widths of horizontal
    /// distance in an extrusion, of distance in a revolution. So one that never leaves an unbounded
    /// window ends too.
    double maxDistance = 1e3;
};

/// Where a ray meets a whole first.
struct SolidHit {
    double t = 0.0;
    glm::dvec3 position{0.0};  ///< in the space of the whole
    std::size_t part = 0;      ///< whose surface it is
    glm::dvec3 place{0.0};     ///< in the tile space of that part
    SolidFace face = SolidFace::Wall;
    /// The gradient of the part's implicit function (d − o(z), d − e; of caps and steps the
    /// direction of their axis) in the coordinates of the whole, not normalised: a covector out of
    /// what is solid, so that where a part was taken away it points into that part. (0,0,0) where
    /// the ray begins inside.
    glm::dvec3 outward{0.0};
    /// The ray begins inside: t = 0, face Origin. One that begins on a surface, or on the border of
    /// a window, and goes inwards is not inside but hits there.
    bool startsInside = false;
};

/// Exact first hits and crossings of rays with a compound of solids, in double precision on the
/// bilinear interpolation of the very maps that shaders read.
///
/// Rays are in the space of the whole. Those with components that are not finite, or with an end
/// below 0 or NaN, meet nothing, nor do those that enter a window more than 2⁵¹ texels out. A hit
/// is where a ray begins to run inside: a touch in one point is none. A ray of zero direction hits
/// what its origin is in.
class SolidTracer {
  public:
    /// Throws textures::InputError for a part without a map or with an empty one, distances or an
    /// extension that are not finite, a profile without pieces, bounds that are NaN, and a matrix
    /// that is not affine and finite.
    explicit SolidTracer(Compound compound, const TraceOptions& options = {});

    /// The first hit with the whole, or nothing; `cost`, where given, is added to.
    [[nodiscard]] std::optional<SolidHit> firstHit(const SolidRay& ray,
                                                   TraceCost* cost = nullptr) const;

    /// All crossings of the ray with part `index` by itself, in order, alternately entering and
    /// leaving, in the coordinates of the whole (`outward` always out of the part). The last one
    /// may enter: the ray ends inside. At most `most` of them.
    [[nodiscard]] std::vector<SolidCrossing> crossings(
        std::size_t index, const SolidRay& ray,
        std::size_t most = std::numeric_limits<std::size_t>::max(),
        TraceCost* cost = nullptr) const;

    /// Whether a point of the whole's space is inside, evaluated directly.
    [[nodiscard]] bool contains(const glm::dvec3& point) const;
    /// Whether it is inside of part `index` by itself. On the far border of a window it belongs to
    /// the replica in the window.
    [[nodiscard]] bool contains(std::size_t index, const glm::dvec3& point) const;

    [[nodiscard]] const Compound& compound() const noexcept { return compound_; }
    [[nodiscard]] const TraceOptions& options() const noexcept { return options_; }
    /// What is known of the map of part `index`.
    [[nodiscard]] const FreeSpace& freeSpace(std::size_t index) const {
        return freeSpaces_.at(index);
    }

  private:
    Compound compound_;
    TraceOptions options_;
    std::vector<FreeSpace> freeSpaces_;
};

/// Whether the whole is solid where its parts are inside or not: ((first ∘ second) ∘ third) …
/// `isInside` has an entry per part.
[[nodiscard]] bool joined(const Compound& compound, const std::vector<char>& isInside) noexcept;

/// Whether a place of its tile space is inside of a solid (without any window; of an extrusion z
/// must be in [0,1]).
[[nodiscard]] bool contains(const Solid& solid, const glm::dvec3& place);

/// d of an extrusion at (u,v), or of the section of a revolution, in the replica of that place.
[[nodiscard]] double distanceAt(const Solid& solid, const glm::dvec3& place);

/// d of the section of a revolution, clamped, as the replica of tile `tile` (integers) has it at a
/// place in it or beside it.
[[nodiscard]] double sectionDistance(const Solid& solid, const glm::dvec3& tile,
                                     const glm::dvec3& place);

/// What steps go by at the places of distanceAt (of extrusions) and sectionDistance.
[[nodiscard]] double stepAt(const Solid& extrusion, const glm::dvec3& place);
[[nodiscard]] double sectionStep(const Solid& solid, const glm::dvec3& tile,
                                 const glm::dvec3& place);

}  // namespace relievo::solids
