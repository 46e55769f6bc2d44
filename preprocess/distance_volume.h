#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The distance volume of a relief for sphere tracing (Donnelly 2005), one plane for each of
/// `slices` ≥ 1 layers of equal depth, the one at the reference surface first. Texel (i,j) of plane
/// k is the voxel over the square of that texel between the depths k/slices and (k+1)/slices. Its
/// value is a lower bound, in tile widths, on the distance from every point of the voxel to the
/// relief, the solid {z ≥ D} under the bilinear surface, whose depth of 1 is `depthScale` > 0 tile
/// widths; 0 where the relief reaches into the voxel or a neighbour of it. A sphere of this radius
/// around any point of the voxel holds nothing of the relief, so that a step of this length along
/// any ray never pierces it. At another scale a that holds for the value times min(1,
/// a/depthScale), for shrinking depths shrinks no distance by more than it shrinks the depths.
///
/// The bound: the relief over the square of a texel lies within the column that begins at the least
/// depth of the surface there, found exactly. The value is the exact distance from the voxel to the
/// nearest column, box to box. Columns reach to the bottom, so that one transform in the plane does
/// for each slice what a transform of voxels needs three for: with the squared depth from the
/// voxel's bottom to the columns as heights, lower envelopes of parabolas along rows and columns
/// (Felzenszwalb and Huttenlocher 2012), in double precision, less what rounding may have added.
///
/// Linear time in the size of the volume. Scratch memory: 16 bytes a texel of the map.
/// `advance` as in MapRequest.
std::vector<textures::Plane> buildDistanceVolume(
    const textures::DepthMap& map, int slices, double depthScale,
    const std::function<void(std::size_t)>& advance = {});

}  // namespace relievo::preprocess
