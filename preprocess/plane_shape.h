#pragma once

#include <vector>

#include "outlines/outline.h"
#include "preprocess/boundary_tree.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// A shape that fills a part of a map's tile and goes on outside as the wrap mode says. In texels.
/// Segments follow each other in their paths and have the inside where
/// cross(end − start, place − start) > 0.
struct PlaneShape {
    /// Closed: what a line crosses an odd number of times from outside to a point of the tile when
    /// the point is inside.
    std::vector<BoundarySegment> edges;
    /// Where the shape ends: the edges without those that only cut it off at the border of the
    /// tile, with the inside to the right of the way from start to end as one looks at the picture.
    /// Under repeat with those of the tiles around that are near, among which are the nearest to
    /// every point of the tile. Empty when the shape is, or fills everything.
    std::vector<BoundarySegment> boundary;
};

/// The shape of a drawing on a map of width × height square texels, or that of one outline. What
/// lies outside of the tile is cut off, and overlaps are merged by the fill rules, so that no
/// segment lies inside the shape. Coordinates are rounded to 2⁻²⁸ tile widths. Throws
/// textures::InputError for coordinates that are not finite, or beyond 10⁶ tile widths.
PlaneShape shapeOf(const outlines::Drawing& drawing, int width, int height,
                   textures::WrapMode wrap);
PlaneShape shapeOf(const outlines::Outline& outline, int width, int height,
                   textures::WrapMode wrap);

}  // namespace relievo::preprocess
