#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace relievo::outlines {

/// A closed curve as a polyline: its last point joins its first. In tile widths, x to the right and
/// y downwards, so that one texel of a map of `width` is 1/width long along both.
using Contour = std::vector<glm::dvec2>;

/// What of the plane a set of contours encloses.
enum class FillRule {
    NonZero,  ///< around what they go, on balance, at least once in either direction
    EvenOdd,  ///< around what they go an odd number of times
};

/// A plane shape.
struct Outline {
    std::vector<Contour> contours;
    FillRule rule = FillRule::NonZero;
};

/// A drawing as shapes: all that it fills, whatever the colour.
struct Drawing {
    std::vector<Outline> shapes;  ///< the drawing is their union, in tile widths
    double aspect = 1.0;          ///< height of the tile over its width
};

}  // namespace relievo::outlines
