#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "outlines/outline.h"

namespace relievo::outlines {

/// Appends a polyline for the Bézier curve with these control points to `contour`, without its
/// first point, and with its last. Nowhere is it further than `tolerance` (> 0, in the unit of the
/// points) from the curve: a curve of degree d whose second differences are at most L long deviates
/// from n chords of equal parameter by at most d·(d−1)·L / (8·n²) (Wang 1984).
void appendQuadratic(const std::array<glm::dvec2, 3>& points, double tolerance, Contour& contour);
void appendCubic(const std::array<glm::dvec2, 4>& points, double tolerance, Contour& contour);

}  // namespace relievo::outlines
