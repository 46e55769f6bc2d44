#pragma once

#include <functional>
#include <optional>
#include <string>

#include "reference/bilinear_tracer.h"
#include "textures/depth_map.h"

namespace relievo::reference::test {

/// A tracer under test: traceBilinear, or one that is wrong on purpose.
using Tracer = std::function<std::optional<TileHit>(const textures::DepthMap&, const TileRay&,
                                                    const TileWindow&)>;

/// The parameters between which a ray is inside the window and z in [0,1], for `maxDistance` tile
/// widths at most; nothing if it never is.
struct RaySpan {
    double begin = 0.0;
    double end = 0.0;
};
std::optional<RaySpan> spanInWindow(const textures::DepthMap& map, const TileRay& ray,
                                    const TileWindow& window, double maxDistance);

/// z − D at parameter t, from textures::sampleBilinear: positive below the surface.
double depthBelow(const textures::DepthMap& map, const TileRay& ray, double t);

/// What is wrong with `hit` as the first hit of the ray, or nothing. It must lie on the surface
/// (or, if it says that it starts inside, at the begin of the ray and below the surface), and no
/// point before it, on a dense row of `samplesPerTexel`, may be below the surface by over 1e-9.
std::optional<std::string> violation(const textures::DepthMap& map, const TileRay& ray,
                                     const TileWindow& window, const std::optional<TileHit>& hit,
                                     double maxDistance, double samplesPerTexel = 32.0);

/// The first hit by marching in tiny steps, then bisection: it may miss a shallow touch, and is
/// never before the true first hit.
std::optional<double> marchToHit(const textures::DepthMap& map, const TileRay& ray,
                                 const TileWindow& window, double maxDistance,
                                 double samplesPerTexel);

/// Wrong on purpose: looks at the surface only on the borders of the cells (and bisects between),
/// so that it misses what a ray meets and leaves again inside one cell.
std::optional<TileHit> traceCellBordersOnly(const textures::DepthMap& map, const TileRay& ray,
                                            const TileWindow& window, double maxDistance);

/// Wrong on purpose: one step a texel, as a search on the grid that goes from cell to cell by
/// diagonals would, so that it never looks into the cells between.
std::optional<TileHit> traceSkippingCells(const textures::DepthMap& map, const TileRay& ray,
                                          const TileWindow& window, double maxDistance);

}  // namespace relievo::reference::test
