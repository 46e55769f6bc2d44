#pragma once

#include <cstddef>
#include <functional>

#include "preprocess/slope_search.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// For which points a cone holds.
enum class ConeGuarantee {
    Texel,     ///< apex at the texel's centre, nothing but texel centres outside: the usual form
    Bilinear,  ///< apex anywhere in the texel's square on the bilinear surface, all of it outside
};

/// The widest cones that hold nothing of the relief: ratios in tile widths per unit of depth,
///
///   c(t) = inf over apexes x of texel t and y with D(y) < D(x) of |x − y| / (D(x) − D(y))
///
/// under the map's wrap mode, +infinity where nothing is higher; the distance is the least over all
/// copies of the tile. Never above the true ratio; under it by a millionth at most for Texel, and
/// for Bilinear by some 5 % (docs/measurements.md), the price of bounding a continuum of chords.
/// With Bilinear a ray that takes the cone of the texel it is over (NEAREST) and the filtered depth
/// (LINEAR) never passes the surface.
///
/// Near chords are tried all (chord_table.h, bilinear_slopes.h), far ones are searched in a
/// quadtree (slope_search.h). Memory: 10 bytes a texel besides map and result, 28 for
/// Bilinear.
///
/// `advance`, when given, is called from any thread with the number of texels just finished.
textures::Plane buildConservativeCones(const textures::DepthMap& map, ConeGuarantee guarantee,
                                       const std::function<void(std::size_t)>& advance = {},
                                       SlopeSearchStatistics* statistics = nullptr);

}  // namespace relievo::preprocess
