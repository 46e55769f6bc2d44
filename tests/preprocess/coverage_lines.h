// Outlines of anti-aliased bitmaps by fitted lines: what marching squares rounds off comes back.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "outline_error.h"
#include "reference/plane_outline.h"
#include "textures/plane.h"

namespace relievo::preprocess {

struct LineStatistics {
    int vertices = 0;  ///< of marching squares
    int onLines = 0;   ///< of them moved onto a line
    int corners = 0;   ///< where two lines were extended to meet
    int left = 0;      ///< vertices left where marching squares had them
};

struct FittedOutline {
    std::vector<reference::OutlineContour> contours;
    std::vector<OutlineCorner> corners;
    LineStatistics statistics;
};

/// The outline of a shape from the area that it covers of every texel, in texels. A line is fitted
/// to every 3×3 texels in the middle of which the outline is: the half plane whose areas differ the
/// least from the coverage (least squares, as LVIRA does in volume-of-fluid methods: Pilliod and
/// Puckett 2004), which is exact for straight outlines. Contours are those of marching squares at
/// the half level, vertices moved onto the line of the nearest texel whose fit is good; where
/// between two such lines fits are bad there is a corner: both are extended to where they meet.
FittedOutline fittedOutline(const textures::Plane& coverage);

}  // namespace relievo::preprocess
