#pragma once

#include <cstdint>

#include "reference/roof_map.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::reference::test {

/// A relief of noise, the same in every run; rounded to 0 and 1 when `isBinary`.
textures::DepthMap noiseRelief(int width, int height, textures::WrapMode wrap, std::uint32_t seed,
                               bool isBinary = false);

/// Conservative cones for any relief: one ratio, the inverse of the steepest slope of the bilinear
/// surface, times `factor`. Up to a factor of 1 no pair of points on the surface contradicts it.
textures::Plane slopeCones(const textures::DepthMap& relief, double factor = 1.0);

/// The roof cones of a small relief by their definition (specification 3.6), every cell of the
/// surrounding tiles against every cell, in double precision, rounded down.
RoofMap bruteForceRoofs(const textures::DepthMap& relief, int layers, int block);

}  // namespace relievo::reference::test
