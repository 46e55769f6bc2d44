#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "preprocess/boundary_tree.h"

namespace relievo::preprocess {

/// The outline before or behind a corner, up to the next one or for kSideLength texels, and then
/// straight on at both ends.
class OutlineSide {
  public:
    /// `segments` in the order in which they lead away from the corner: those behind it as they
    /// are, those before it from the last one back.
    OutlineSide(std::vector<BoundarySegment> segments, bool isBehind);

    /// How far it goes without being continued.
    [[nodiscard]] double length() const noexcept { return length_; }
    /// The distance to it, in texels: < 0 where the inside is.
    [[nodiscard]] double distance(const glm::dvec2& place) const noexcept;

  private:
    std::vector<BoundarySegment> segments_;
    double length_ = 0.0;
};

/// Distances to both sides of a corner, in texels.
struct SideDistances {
    double toA = 0.0;
    double toB = 0.0;
};

/// A corner of an outline, as textures::ShapeCreases has it: A and B are the distances to its
/// sides, and the distance around it is the larger one, if it is convex, or the smaller one.
struct OutlineCorner {
    glm::dvec2 place{0.0};  ///< texels
    double turn = 0.0;      ///< by how much the outline turns, in (0, π)
    bool isConvex = true;
    OutlineSide before;
    OutlineSide behind;
    bool isBehindA = false;  ///< A is the side behind

    [[nodiscard]] SideDistances sides(const glm::dvec2& where) const noexcept;
    /// The distance of a place with these.
    [[nodiscard]] double distance(const SideDistances& sides) const noexcept;
    /// Whether that is the one to A.
    [[nodiscard]] bool isOnA(const SideDistances& sides) const noexcept;
    /// The code of a sample there, in texels.
    [[nodiscard]] double code(const SideDistances& sides) const noexcept;
};

/// How much of the outline a side has before it goes straight on, in texels.
inline constexpr double kSideLength = 96.0;
/// Corners that are further apart along the outline than this, in texels, have no cell in common.
inline constexpr double kFarApart = 12.0;
/// Corners that have another one as near as this along the outline, in texels, share all their
/// cells with it.
inline constexpr double kCrowded = 2.5;

/// The corners of an outline.
struct OutlineCorners {
    std::vector<OutlineCorner> corners;
    std::vector<glm::dvec2> crowded;  ///< places of those that have another one within kCrowded
};

/// The corners of the segments of a PlaneShape, in texels: where it turns by at least `leastTurn`
/// (radians), in the order of the segments that begin there. Of two that are near each other the
/// side between is the same one of A and B to both, or the crease of one would end in cells of the
/// other.
OutlineCorners outlineCorners(const std::vector<BoundarySegment>& boundary, double leastTurn);

}  // namespace relievo::preprocess
