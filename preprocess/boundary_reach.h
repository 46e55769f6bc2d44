#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "preprocess/boundary_tree.h"

namespace relievo::preprocess {

/// How far the nearest of these segments is at most, in texels, from any place of a tile of
/// width × height texels that repeats: what lies further outside the tile is the nearest of none.
/// Half a diagonal of the tile at most, and so for no segments. By distances between blocks of
/// texels that hold some of a segment.
double boundaryReach(std::span<const BoundarySegment> segments, int width, int height);

/// Whether some of a segment is no further than `reach` (texels, along either axis) from the tile.
bool isNearTile(const BoundarySegment& segment, const glm::dvec2& size, double reach);

}  // namespace relievo::preprocess
