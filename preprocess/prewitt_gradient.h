#pragma once

#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// The largest kernel of prewittGradient.
inline constexpr int kLargestPrewitt = 9;

/// The unit gradient of `values` (u to the right, v downwards, square texels) by Prewitt's kernel
/// of size × size texels, which is the slope of the plane that fits them best: weights −r … r along
/// one axis, the same in all rows of the other. (0,0) where the slope is 0. `size` is odd, from 3
/// to kLargestPrewitt. (Prewitt 1970; the thesis, 4.2.1, uses 3 to 9.)
void prewittGradient(const textures::Plane& values, textures::WrapMode wrap, int size,
                     textures::Plane& gradientX, textures::Plane& gradientY);

}  // namespace relievo::preprocess
