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
    /// tile. Under repeat and mirror with those of the eight tiles around, among which are the
    /// nearest to every point of the tile. Empty when the shape is, or fills everything.
    std::vector<BoundarySegment> boundary;
};

/// The shape of an outline on a map of width × height square texels. What lies outside of the tile
/// is cut off, and overlaps are merged by the fill rule, so that no segment lies inside the shape.
/// Coordinates are rounded to 2⁻²⁸ tile widths.
PlaneShape shapeOf(const outlines::Outline& outline, int width, int height,
                   textures::WrapMode wrap);

}  // namespace relievo::preprocess
