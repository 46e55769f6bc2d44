#pragma once

#include <cstddef>
#include <functional>

#include "preprocess/boundary_tree.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// How far a boundary is from every texel centre, and which way.
struct BoundaryDistances {
    textures::Plane distance;  ///< texels, ≥ 0; +infinity everywhere without a boundary
    /// The unit vector from the nearest point of the boundary; on it the normal of the segment, to
    /// the left of the way from start to end as one looks at the picture, away from the inside of a
    /// PlaneShape. (0,0) without a boundary.
    textures::Plane awayX;
    textures::Plane awayY;
};

/// The exact distance from the centres of width × height texels to the nearest segment, up to the
/// rounding of floats (2⁻²¹ of the distance and the length of a segment, and 10⁻⁶ texels). Packets
/// of 4×4 texels go down the tree at once, from the nodes that count for the block of 32×32 they
/// are in, and begin with the segment that was nearest beside them, so that few nodes are opened.
/// The same whatever the number of threads.
///
/// `advance`, when given, is called from any thread with the number of texels just finished.
BoundaryDistances measureBoundaryDistances(const BoundaryTree& tree, int width, int height,
                                           const std::function<void(std::size_t)>& advance = {});

}  // namespace relievo::preprocess
