#pragma once

#include "textures/plane.h"

namespace relievo::textures {

/// A map of half the size, rounded down but at least 1, over the same area: each sample is the mean
/// of what it covers, with the parts of samples that an odd size gives it. Computed in double,
/// rounded once.
Plane halvedByArea(const Plane& fine);

}  // namespace relievo::textures
