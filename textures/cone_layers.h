#pragma once

#include <vector>

#include "textures/map_set.h"

namespace relievo::textures {

/// The cones on the surface in a map set, which must outlive this: the channel `cone`, or `cone0`,
/// `cone1` … for 4 or 8 sectors of ray directions; empty when `maps` has neither. Throws
/// InputError, without a file name, for another number of sectors.
std::vector<const Plane*> coneLayersOf(const MapSet& maps);

}  // namespace relievo::textures
