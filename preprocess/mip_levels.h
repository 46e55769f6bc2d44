#pragma once

#include <vector>

#include "textures/depth_map.h"

namespace relievo::preprocess {

/// The relief and its mip levels down to 1×1, with the sizes of OpenGL. Each is a relief of its own
/// on the same tile; an odd size makes texels that are no squares (DepthMap::texelAspect).
std::vector<textures::DepthMap> reliefLevels(textures::DepthMap relief);

}  // namespace relievo::preprocess
