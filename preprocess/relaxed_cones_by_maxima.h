#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The texels that none of their eight neighbours is higher than, under the map's wrap mode: one
/// byte a texel, 1 at a maximum. All of a flat top counts, and so does the inside of every plain.
std::vector<std::uint8_t> markLocalMaxima(const textures::DepthMap& map);

/// Relaxed cones by the thesis' linear method (algorithm 3.6 with erratum E4): the widest cones
/// that hold no local maximum of the relief higher than the apex, by one exact distance transform
/// for each of at most `levels` classes of depths (cones_by_levels.h).
///
/// A baseline, and **not safe**: a ray may leave the relief past a crest that slopes and so has no
/// maximum where the ray crosses it (specification 3.3).
///
/// Units, rounding, unlimited cones and `advance` are those of buildConesByLevels.
textures::Plane buildRelaxedConesByMaxima(const textures::DepthMap& map, int levels = 256,
                                          const std::function<void(std::size_t)>& advance = {});

}  // namespace relievo::preprocess
