#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "preprocess/slope_search.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The roof cones of one sector of ray directions.
struct RoofConeLayer {
    textures::Plane roof;  ///< least depth over the block of each cell
    /// Of the empty cone with its apex on the roof: tile widths per unit of depth, +infinity where
    /// nothing is higher than the roof.
    textures::Plane ratio;
};

/// Which roof cones to build.
struct RoofConeRules {
    int sectors = 4;  ///< 1: all directions; 4: quadrants (vx<0) + 2·(vy<0); 8: + 4 where steep
    int block = 1;    ///< reach of a block in cells, at least 1
};

/// Roof cones (specification 3.6): the near relief is held under a roof, the cone says only what
/// lies beyond, so that a search is exact and takes wide steps beside cliffs as well. Cell (i,j),
/// the bilinear patch between texel centres i and i+1, j and j+1, is stored at texel (i,j). Its
/// block is the cells within `block` of it, or in a sector itself and the `block` cells ahead along
/// each axis; under mirror and clamp the cell before texel 0 shares the entry of cell 0.
///
///   ratio = inf over points x of the cell and y outside the block, in the directions of the sector
///           and with D(y) < roof, of |x − y| / (roof − D(y))
///
/// Never above the true ratio; under it by 6 % at most, for cells far away by 3 %: chords end at
/// samples, with the correction that makes those bound the patches between them
/// (bilinear_slopes.h). Memory: 10 bytes a texel besides map and layers.
///
/// `advance` is called with the number of cells just finished, `sectors` times the map in all.
std::vector<RoofConeLayer> buildRoofCones(const textures::DepthMap& map, const RoofConeRules& rules,
                                          const std::function<void(std::size_t)>& advance = {},
                                          SlopeSearchStatistics* statistics = nullptr);

}  // namespace relievo::preprocess
