// Anti-aliased bitmaps of shapes.
#pragma once

#include "preprocess/plane_shape.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The exact area of the shape in every texel, in [0,1]; rounded to 1/levels unless levels is 0.
textures::Plane coverageOf(const PlaneShape& shape, int width, int height, int levels);

}  // namespace relievo::preprocess
