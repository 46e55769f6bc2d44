#pragma once

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The slopes of a relief, of the size of its map: depth per tile width, in the metric, at depth
/// scale 1.
struct Derivatives {
    textures::Plane dx;  ///< along u
    textures::Plane dy;  ///< along v, in the metric: per tile width too, not per tile height
};

/// Central differences of the depths under the map's wrap mode. Texels are square, so the distance
/// between the two samples is 2/width in both directions, whatever the aspect.
Derivatives buildDerivatives(const textures::DepthMap& map);

}  // namespace relievo::preprocess
