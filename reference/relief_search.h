#pragma once

#include "reference/map_search.h"
#include "textures/depth_map.h"

namespace relievo::reference {

/// Relief mapping (Policarpo, Oliveira, Comba 2005): `linearSteps` equal steps until one lies below
/// the surface, then `bisections` of it; one lookup each. Steps over what is thinner than a step.
MapSearchResult searchLinearBinary(const textures::DepthMap& relief, const DescendingRay& ray,
                                   int linearSteps = 32, int bisections = 5);

}  // namespace relievo::reference
