#pragma once

#include <vector>

#include "preprocess/boundary_tree.h"
#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// Signed distances, in texels, that keep the corners of an outline sharp: samples and codes of
/// textures::ShapeCreases.
///
/// Why. The zero level of one bilinear distance is a hyperbola in each cell, and no choice of its
/// samples bends around a corner: right angles lose up to 0.48 texel, tips of 36° 1.5.
///
/// The idea of several distances for corners is Chlumský's (Shape decomposition for multi-channel
/// distance fields, 2015), who takes the median of three.
struct CreasedDistances {
    textures::Plane distance;
    textures::Plane code;
    textures::Plane step;
    int sharpCorners = 0;  ///< exact where sides are straight
    int roundCorners = 0;  ///< left as they were: something else is within a texel or two
};

/// Where the outline of a drawing turns by more it has a corner (5°): less is a curve's polyline.
inline constexpr double kCornerOfDrawing = 0.0873;
/// Of a bitmap (35°): less than the corners that sharpenCorners puts back, more than the polylines
/// turn that coverageBoundary makes of curves.
inline constexpr double kCornerOfBitmap = 0.61;

/// Creases `distance`, the signed distances (< 0 inside) of texel centres to `boundary`, the
/// segments of a PlaneShape. Only samples of cells around corners change that the outline passes.
/// Outside of a convex corner of angle α they become smaller, by at most √2·(1 − sin(α/2)), and
/// inside of a reflex one larger; none gets further from 0 by more than a twentieth of a texel.
/// Corners stay round that have another part of the outline, or another corner of the other kind,
/// within a few texels.
///
/// A corner is where the boundary turns by at least `leastTurn` (radians). Where none becomes sharp
/// codes and steps have no texels.
CreasedDistances creaseCorners(const std::vector<BoundarySegment>& boundary,
                               textures::Plane distance, textures::WrapMode wrap,
                               double leastTurn = kCornerOfDrawing);

}  // namespace relievo::preprocess
