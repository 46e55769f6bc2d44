#pragma once

#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::textures {

/// The value of `plane` at (u,v), bilinearly interpolated between texel centres under `wrap`, in
/// double precision. It is what GL_LINEAR returns without a mip chain.
double sampleBilinear(const Plane& plane, double u, double v, WrapMode wrap);

/// The value of the texel whose square holds (u,v): what GL_NEAREST returns.
double sampleNearest(const Plane& plane, double u, double v, WrapMode wrap);

}  // namespace relievo::textures
