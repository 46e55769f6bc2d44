#pragma once

#include <vector>

#include "textures/depth_map.h"

namespace relievo::preprocess {

/// A map of half the size, rounded down but at least 1, over the same area: each sample is the mean
/// of what it covers, with the parts of samples that an odd size gives it. Computed in double,
/// rounded once.
textures::Plane halvedByArea(const textures::Plane& fine);

/// The relief and its mip levels down to 1×1, with the sizes of OpenGL. Each is a relief of its own
/// on the same tile; an odd size makes texels that are no squares (DepthMap::texelAspect).
std::vector<textures::DepthMap> reliefLevels(textures::DepthMap relief);

}  // namespace relievo::preprocess
