#pragma once

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

/// Called from any thread with rows [first, end) of a map that have just been measured, and that
/// will not be touched again.
using RowsMeasured = std::function<void(BoundaryDistances& distances, int first, int end)>;

/// The exact distance from the centres of width × height texels to the nearest segment, up to the
/// rounding of floats (2⁻²¹ of the distance and the length of a segment, and 10⁻⁶ texels). A block
/// of 32×32 texels collects what of the tree may be the nearest to any of its places, its quarters
/// and theirs what of that may be so to theirs, and 8×8 places go through what is left at once.
/// The same whatever the number of threads.
BoundaryDistances measureBoundaryDistances(const BoundaryTree& tree, int width, int height,
                                           const RowsMeasured& rowsMeasured = {});

}  // namespace relievo::preprocess
