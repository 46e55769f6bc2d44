#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "reference/bilinear_cell.h"

namespace relievo::solids {

/// The distance from the axis along a line, s(t) = √(m² + w(t)²) with w = w0 + c·t: a hyperbola.
struct RadialLine {
    double closest = 0.0;  ///< m ≥ 0: how far the line keeps from the axis
    double start = 0.0;    ///< w0
    double speed = 0.0;    ///< c ≥ 0; 0 for a line along the axis

    [[nodiscard]] double along(double t) const noexcept { return start + speed * t; }
    [[nodiscard]] double radius(double t) const noexcept;
};

/// d − e along a line in one bilinear cell of the section of a revolution, on a stretch on which
/// the radius does not turn.
struct SectionCell {
    reference::BilinearCell cell;  ///< of d, tile widths
    RadialLine line;
    double texels = 1.0;       ///< in a tile width
    double firstColumn = 0.0;  ///< radius of the cell's first texel centre, in texels
    double rowStart = 0.0;     ///< local row coordinate at t = 0
    double rowSpeed = 0.0;     ///< rows per t
    double extension = 0.0;

    /// The place in the cell, (0,0) to (1,1).
    [[nodiscard]] glm::dvec2 place(double t) const noexcept;
    [[nodiscard]] double value(double t) const noexcept;
    [[nodiscard]] double derivative(double t) const noexcept;
    /// A bound of |second derivative| between a and b.
    [[nodiscard]] double curvature(double a, double b) const noexcept;
    /// What rounding may make of a value, about.
    [[nodiscard]] double rounding() const noexcept;
    /// Negative at t, or 0 and going down there.
    [[nodiscard]] bool isInside(double t) const noexcept;
};

/// Appends the places between a and b where the section's d − e changes its sign, in order; their
/// number is odd when isInside(a) and isInside(b) differ. Stretches are halved until the curvature
/// bound says that there is none or that the function is monotone; no dip deeper than rounding is
/// missed.
void appendSignChanges(const SectionCell& section, double a, double b, std::vector<double>& places);

}  // namespace relievo::solids
