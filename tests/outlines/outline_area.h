#pragma once

#include <vector>

#include "outlines/outline.h"

namespace relievo::outlines {

/// The area inside a polyline, positive where it goes around it from x to y.
double signedArea(const Contour& contour);

/// The sum over all contours of all shapes: the area where they do not overlap and go around holes
/// the other way.
double signedArea(const std::vector<Outline>& shapes);

}  // namespace relievo::outlines
