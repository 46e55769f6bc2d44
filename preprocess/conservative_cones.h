#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The work of a cone search. It depends on the map alone, not on threads or the machine.
struct ConeSearchStatistics {
    std::uint64_t nodes = 0;   ///< pyramid nodes whose bound was computed
    std::uint64_t texels = 0;  ///< texels whose ratio was computed
};

/// The widest cones that hold nothing of the relief, apex on the surface at each texel centre, for
/// texel centres:
///
///   c(t) = inf over y with D(y) < D(t) of |t − y| / (D(t) − D(y))
///
/// in tile widths per unit of depth, under the map's wrap mode; exact, rounded down to float.
/// +infinity where no texel is higher. The distance between texels is the least over all copies of
/// the tile.
///
/// Method: best candidates first through a pyramid of least depths, pruned by
/// distance(node)/(D(t) − least depth(node)), started from the texels that limit the neighbours
/// (specification 3.2). A plane below the surface of each node (relief_tree.h) rules
/// out smooth slopes, where that bound is loose. Memory: 15 bytes a texel besides map and result.
///
/// `advance`, when given, is called from any thread with the number of texels just finished.
textures::Plane buildConservativeCones(const textures::DepthMap& map,
                                       const std::function<void(std::size_t)>& advance = {},
                                       ConeSearchStatistics* statistics = nullptr);

}  // namespace relievo::preprocess
