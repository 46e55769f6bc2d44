#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "reference/plane_outline.h"

namespace relievo::reference {

/// A ray in metric space: lengths are in tile widths. P(t) = origin + t·direction for t in
/// [from, to]; the direction need not be normalised. `from` must be finite, `to` may be infinite.
///
/// Extrusions: x = u, y = ρ·v, z the normalised depth. Revolutions: x and y from the axis, z = ρ
/// times the normalised depth, as high as the section's rows are in tile widths.
struct SolidRay {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0};
    double from = 0.0;
    double to = 1e3;

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// The first point of a ray in a solid. A ray that begins on a cap hits it there and does not start
/// inside.
struct SolidHit {
    double t = 0.0;
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};  ///< outwards, unit length; 0 where the ray starts inside
    bool startsInside = false;
};

/// The first hit with {(x,y) inside the outline, 0 ≤ z ≤ 1}: walls and both caps. Exact up to the
/// rounding of doubles.
std::optional<SolidHit> hitExtrusion(const PlaneOutline& outline, const SolidRay& ray);

/// The first hit with {(|(x,y)|, z) inside the outline}, which is a section in (s, z): each segment
/// is a part of a cone or a ring, met by a quadratic. Of the section only s ≥ 0 counts; it should
/// be drawn on both sides of the axis where it reaches it, so that the axis is no wall.
std::optional<SolidHit> hitRevolution(const PlaneOutline& section, const SolidRay& ray);

/// A stretch of depths in which an offset is continuous.
struct OffsetPiece {
    double top = 0.0;
    double bottom = 1.0;
    std::function<double(double)> offset;  ///< of z, in tile widths
    double steepest = 0.0;                 ///< no less than |offset'| anywhere in the piece
};

/// The offset over all depths, pieces one after the other from 0 to 1.
using OffsetProfile = std::vector<OffsetPiece>;

/// What sphere tracing leaves open: hits are of solids grown by so much, in tile widths.
inline constexpr double kOffsetTolerance = 1e-10;

/// The first hit with {distance(x,y) ≤ o(z) + kOffsetTolerance, 0 ≤ z ≤ 1}, where `distance` is the
/// true signed distance to the outline. By sphere tracing: along the ray distance − o changes by at
/// most |direction.xy| + steepest·|direction.z| per unit of t, so that (distance − o) over that is
/// a step which nothing of the solid is passed by. The normal is that of the sheet hit; its z
/// component is per unit of z, before it is made of unit length.
std::optional<SolidHit> hitOffsetExtrusion(const PlaneOutline& outline,
                                           const OffsetProfile& profile, const SolidRay& ray);

/// The first hit with {distance(|(x,y)|, z) ≤ extension + kOffsetTolerance}, by the same means.
std::optional<SolidHit> hitOffsetRevolution(const PlaneOutline& section, double extension,
                                            const SolidRay& ray);

}  // namespace relievo::reference
