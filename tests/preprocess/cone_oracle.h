#pragma once

#include <cstddef>

#include "tests/preprocess/small_reliefs.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The ratio of the widest empty cone on texel (i,j), by trying every texel in double precision.
/// `copies` tiles in each direction besides the tile itself are tried literally, with the depths
/// that DepthMap::at gives there: 1 holds the nearest copy of everything.
double bruteForceRatio(const textures::DepthMap& map, int i, int j, int copies);

/// How many texels of `ratio` differ from brute force: above the true ratio, under it by more than
/// two millionths, or limited where the other is not.
std::size_t countWrongRatios(const textures::Plane& ratio, const textures::DepthMap& map,
                             int copies);

/// Whether a float ratio is the true one up to rounding, and not above it.
bool isTrueRatio(float ratio, double truth);

}  // namespace relievo::preprocess
