#pragma once

#include <vector>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::textures {

/// Least depths over ever larger squares. levels[0] is the map itself; texel (i,j) of levels[k] is
/// the least depth of the texels [i·2ᵏ, (i+1)·2ᵏ) × [j·2ᵏ, (j+1)·2ᵏ) that the map has; the last
/// level is 1×1. Sizes halve rounding up, so any map size works.
struct DepthPyramid {
    std::vector<Plane> levels;
};

/// The pyramid of a map of at least one texel. It takes 4/3 of the map's memory.
DepthPyramid buildDepthPyramid(const Plane& depth);

/// The least depth of each bilinear cell of `map`; cell (i,j), between texel centres i and i+1, at
/// texel (i,j): what a search in a pyramid has at its finest level.
Plane leastDepthsOfCells(const DepthMap& map);

}  // namespace relievo::textures
