// Anti-aliased bitmaps of outlines, and outlines of bitmaps.
#pragma once

#include <vector>

#include "preprocess/boundary_tree.h"
#include "preprocess/plane_shape.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The exact area of the shape in every texel, in [0,1]; rounded to 1/levels unless levels is 0.
textures::Plane coverageOf(const PlaneShape& shape, int width, int height, int levels);

/// The half level of the bilinear coverage by marching squares, in texels. Outside the bitmap there
/// is nothing.
std::vector<BoundarySegment> halfLevel(const textures::Plane& coverage);

}  // namespace relievo::preprocess
