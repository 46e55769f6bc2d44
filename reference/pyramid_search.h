#pragma once

#include <span>

#include "reference/map_search.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::reference {

/// Exact search in a pyramid of least depths (Oh, Ki, Lee 2006; Tevs, Ihrke, Seidel 2008), over a
/// relief that repeats: levels[k] holds the least depths of 2ᵏ×2ᵏ cells of the tile
/// (textures::buildDepthPyramid of textures::leastDepthsOfCells). A lookup of a node lets the ray
/// go down to its least depth; if it leaves the node before that, it goes on in the next node, one
/// level up where it also leaves the parent. In a single cell the quadratic is solved with one more
/// lookup. Throws std::invalid_argument for another wrap mode.
MapSearchResult searchByPyramid(const textures::DepthMap& relief,
                                std::span<const textures::Plane> levels, const DescendingRay& ray);

}  // namespace relievo::reference
