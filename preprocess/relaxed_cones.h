#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "preprocess/conservative_cones.h"
#include "preprocess/slope_search.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The widest cones in which a ray that starts above the apex pierces the relief at most once:
/// ratios in tile widths per unit of depth (specification 3.3),
///
///   c(t) = inf over apexes x of texel t and y with D(y) < D(x) of |x − y| / (D(x) − D(y)),
///
/// y only where the depth grows along the direction from x to y just after y: nowhere else can a
/// ray come out of the relief again. +infinity where nothing limits a cone.
///
/// Texel: x and y at texel centres. Bilinear: x anywhere in the texel's square, y anywhere on the
/// bilinear surface, so that a ray that takes the cone of the texel it is over (NEAREST) and the
/// filtered depth (LINEAR) never comes out again; bounded by crest_search.h far away and
/// near_crests.h around the texel. Never above the true ratio.
///
/// Under repeat and mirror a cone ends four tiles away (crest_search.h) even where nothing limits
/// it so near. Memory: 20 bytes a texel besides map and result.
///
/// `advance`, when given, is called from any thread with the number of texels just finished.
textures::Plane buildRelaxedCones(const textures::DepthMap& map, ConeGuarantee guarantee,
                                  const std::function<void(std::size_t)>& advance = {},
                                  SlopeSearchStatistics* statistics = nullptr);

/// The same for the rays of each of 1, 4 or 8 sectors of directions, in the order of chordSector
/// (slope_search.h): only what lies ahead of a ray limits its cone. `advance` is called with
/// `sectors` times the texels of the map in all.
std::vector<textures::Plane> buildRelaxedConeSectors(
    const textures::DepthMap& map, ConeGuarantee guarantee, int sectors,
    const std::function<void(std::size_t)>& advance = {},
    SlopeSearchStatistics* statistics = nullptr);

}  // namespace relievo::preprocess
