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

/// Central differences of the depths under the map's wrap mode. The distance between
/// the two samples is 2/width along u and 2·texelAspect/width along v, whatever the map's aspect.
Derivatives buildDerivatives(const textures::DepthMap& map);

}  // namespace relievo::preprocess
