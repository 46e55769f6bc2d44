#pragma once

#include <vector>

#include "textures/map_set.h"

namespace relievo::textures {

/// The channels of one sector of ray directions of a map of roof cones.
struct RoofLayer {
    const Plane* roof;   ///< least depth over the block of each cell
    const Plane* ratio;  ///< tile widths per unit of depth, of the empty cone with its apex there
};

/// The roof cones in a map set, which must outlive this.
struct RoofLayers {
    std::vector<RoofLayer> layers;  ///< none, 1, 4 or 8
    int block = 1;                  ///< `relievo:block`: cells around, or ahead in a sector
};

/// The channels `roof` and `ratio` as one layer, or `roof0`, `ratio0`, `roof1` … as 4 or 8; no
/// layer when `maps` has neither. Throws InputError, without a file name, for a roof without its
/// ratio (or the other way round), another number of layers, or a `relievo:block` that is no number
/// from 1.
RoofLayers roofLayersOf(const MapSet& maps);

}  // namespace relievo::textures
