#pragma once

#include <span>

#include "textures/plane.h"

namespace relievo::preprocess {

/// For each texel an ellipse in the unit disk of directions, of which a light at (x, y, z), a unit
/// vector with x along u, y along v in the metric and z up, is the point (x,y): it is seen where
/// the point lies in the ellipse,
/// with (p,q) = (x,y) − (centreX, centreY) turned back by `angle`: (p/longer)² + (q/shorter)² ≤ 1.
struct VisibilityEllipses {
    textures::Plane centreX;  ///< channel `ellipsex`
    textures::Plane centreY;  ///< channel `ellipsey`
    textures::Plane longer;   ///< channel `ellipsea`, half the longer axis
    textures::Plane shorter;  ///< channel `ellipseb`, half the shorter axis
    textures::Plane angle;  ///< channel `ellipseangle`: from +u to the longer axis, −π/2 to π/2
};

/// Ellipses in the place of horizons, for soft or cheap shadows (Heidrich, Daubert, Kautz and
/// Seidel 2000): five numbers a texel for any number of azimuths. `horizons` are those of at least
/// 3 evenly spread azimuths, the one of +u first (horizon_map.h); the ellipses are for one depth
/// scale, in tile widths, `depthScale` ≥ 0.
///
/// The directions that a texel sees are taken for sectors of the disk, each as long as the cosine
/// of its horizon's elevation. Their ellipse has the centre of mass and the second moments of these
/// sectors: the unit disk on a plain, and the best fit to the area in this sense elsewhere. Where
/// the sectors are no ellipse it claims some directions that are hidden, and the other way round.
VisibilityEllipses fitVisibilityEllipses(std::span<const textures::Plane* const> horizons,
                                         double depthScale);

}  // namespace relievo::preprocess
