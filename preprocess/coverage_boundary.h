#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/boundary_tree.h"
#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// Where a shape that a bitmap covers ends.
struct CoverageBoundary {
    /// As PlaneShape::boundary: the inside to the right, under repeat with what of the tiles around
    /// is near.
    std::vector<BoundarySegment> segments;
    /// For each texel, row by row, whether its centre is inside: 1 or 0.
    std::vector<std::uint8_t> inside;
};

/// The outline at half coverage of a bitmap in [0,1], with its corners (traceCoverage,
/// sharpenCorners). Its points are joined by segments that are within 0.01 texels of them.
CoverageBoundary coverageBoundary(const textures::Plane& coverage, textures::WrapMode wrap);

}  // namespace relievo::preprocess
