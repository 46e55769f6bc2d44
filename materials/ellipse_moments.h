#pragma once

#include <span>
#include <vector>

#include "textures/plane.h"

namespace relievo::materials {

/// Visibility ellipses in a form that can be filtered: of two ellipses whose longer axes point to
/// −89° and to 89° the mean angle would be 0. Three floats a texel each.
struct EllipseMoments {
    std::vector<float> centres;  ///< x, y, 0
    /// xx, xy, yy of the matrix with the axes of the ellipse and the squares of its half axes: four
    /// times the second moments of its area.
    std::vector<float> squares;
};

/// `planes` are the channels ellipsex, ellipsey, ellipsea, ellipseb, ellipseangle, of one size.
EllipseMoments ellipseMoments(std::span<const textures::Plane* const> planes);

}  // namespace relievo::materials
