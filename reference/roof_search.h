#pragma once

#include "reference/map_search.h"
#include "reference/roof_map.h"
#include "textures/depth_map.h"

namespace relievo::reference {

/// The exact search of specification 3.6. Above the roof of the cell, which takes one lookup, the
/// ray goes on to the end of the cone step or to where it comes down to the roof or leaves the
/// block, whichever is later; in the last case, and where a step does not leave the cell, the cell
/// is solved with a second lookup, and left at its exit without a hit. The cell is a pair of
/// integers that only ever moves forward along the ray.
MapSearchResult searchByRoofs(const textures::DepthMap& relief, const RoofMap& roofs,
                              const DescendingRay& ray);

}  // namespace relievo::reference
