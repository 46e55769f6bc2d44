#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "preprocess/view_grid.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The displacement of a ray that leaves the curved relief without a hit.
inline constexpr float kNoHit = -1.0f;

/// The table of view-dependent displacement mapping (Wang, Wang, Tong, Lin, Hu, Guo and Shum 2003):
/// for each view of `grid` a plane, in the order of ViewGrid::view, of the distances in tile widths
/// that a ray goes from the centre of a texel on the reference surface until it meets the relief;
/// kNoHit where it leaves the relief before, over a silhouette.
///
/// The base surface bends away from its tangent plane at the texel by κs²/2 at the horizontal
/// distance s along the ray, κ its curvature that way: the second-order form of any surface, and
/// exact for quadrics (Oliveira and Policarpo 2005). A ray of elevation e is then at the depth
///   z(s) = s·tan e − κs²/2,    s = (distance)·cos e,
/// below the base, a straight line on the map whose depth is a parabola. Along it the depth
/// a·D(s) of a bilinear cell is quadratic as well, so that the first hit is a root of a quadratic
/// in each cell: the hit is exact, and that of a plane base for κ = 0. The ray leaves the relief
/// where z(s) = 0 again, at s = 2·tan e/κ. Measured on a circle in place of the parabola, z differs
/// by terms of the order κ²s³.
///
/// Depths enter by z/a alone, so that the table serves every scale a' of the depth: s for the
/// tangent tan e' and the curvature κ' is that for tan e'·a/a' and κ'·a/a'.
///
/// Values are rounded down: all of the way to a hit is above the surface, so a shorter one never
/// leads behind it.
///
/// For one texel and azimuth z(s) grows with the elevation and falls with the curvature,
/// everywhere, and so hits come later, if at all, the lower the ray and the greater the curvature.
/// Each search therefore begins in the cell in which the next steeper and the next lesser curved
/// one ended, and the cells of the line are made once for all of them: time O(cells along the
/// longest ray + elevations·curvatures) for each texel and azimuth, with steps from cell to cell
/// shared by all elevations. In parallel over rows. Scratch memory: 40 bytes for each cell of the
/// longest ray and thread. `advance` as in MapRequest.
std::vector<textures::Plane> buildViewDisplacement(
    const textures::DepthMap& map, const ViewGrid& grid,
    const std::function<void(std::size_t)>& advance = {});

}  // namespace relievo::preprocess
