#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Conservative cones by the thesis' linear method (HDDT, algorithm 3.5, with erratum E4: ratios
/// start unlimited and only shrink): one exact distance transform for each depth level, so
/// O(texels · levels). A baseline for buildConservativeCones.
///
/// The depths of the map are grouped into at most `levels` ≥ 1 classes: one for each distinct depth
/// when there are so few, as in 8-bit maps, else equal steps. For a class with least depth l,
///
///   c(t) ≤ distance({D in this class or a higher one}) / (D(t) − l)
///
/// with the distance at least one texel where t is in the class itself. With a class for each depth
/// the result is exact where texels are square; otherwise, and in classes of several depths, it is
/// narrower, never wider, than the exact cone.
///
/// Units, rounding and unlimited cones are those of buildConservativeCones. `advance`, when given,
/// is called with numbers of texels that add up to those of the map.
textures::Plane buildConesByLevels(const textures::DepthMap& map, int levels = 256,
                                   const std::function<void(std::size_t)>& advance = {});

/// The same for cones that need hold only none of the marked texels, one byte a texel, not 0 where
/// it is marked. With no texel marked all cones are unlimited.
textures::Plane buildConesToTexels(const textures::DepthMap& map,
                                   std::span<const std::uint8_t> marked, int levels,
                                   const std::function<void(std::size_t)>& advance = {});

}  // namespace relievo::preprocess
