#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "preprocess/texel_sides.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// A point of the outline of a bitmap, on the line between two neighbouring texel centres of which
/// one is inside.
struct OutlinePoint {
    glm::dvec2 place{0.0};  ///< texels
    /// Whether it is the mean of a straight piece, found by adding up coverage from a full texel to
    /// an empty one, instead of by interpolation between two texels.
    bool isSure = false;
};

/// A piece of the outline: its points in order, with the inside to the right of the way from each
/// to the next as one looks at the picture (below a way to the right).
struct OutlineChain {
    std::vector<OutlinePoint> points;
    bool isClosed = true;
    /// From the first point to where a closed chain comes back: (0,0), or some tiles further on
    /// where the shape goes around a repeated tile.
    glm::dvec2 period{0.0};
};

/// The outline of the texels that are covered by at least a half, as chains of points between texel
/// centres (marching squares; Lorensen and Cline 1987, in the plane). At most one crossing lies
/// between two centres; where a cell has four, the bilinear interpolation of its corners says which
/// are joined. No chain crosses another.
///
/// A point between two centres is where the sum of the coverage along the row or column, from the
/// full texel inside to the empty one outside, puts the outline (the height function of
/// volume-of-fluid methods): exact for a straight edge of exact coverage. Where there are no such
/// texels near, it is interpolated linearly.
///
/// Chains of repeated tiles are closed and listed once; of others they end at the border of the
/// tile. `coverage` in [0,1]; `sides` are those of it, under the wrap mode that counts. The same
/// for any number of threads: those find where chains may begin, and the points, not their order.
std::vector<OutlineChain> traceCoverage(const textures::Plane& coverage, const TexelSides& sides);

}  // namespace relievo::preprocess
