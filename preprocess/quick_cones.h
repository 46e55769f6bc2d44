#pragma once

#include <cstddef>
#include <functional>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Conservative cones by a fixed walk up the pyramid of least depths (after Valasek and Bán, Quick
/// Cone Map Generation on the GPU, 2022): O(texels · levels), narrower than the widest ones.
///
/// Around the apex the eight neighbours are taken as they are. Then, level by level, the squares of
/// half the size that lie in the 3×3 nodes around the apex and not in the 3×3 nodes of the level
/// before: at most 27 for each level, whatever they hold. A square with least depth d at distance r
/// allows the ratio r/(D(t) − d), as if its nearest texel were its highest one. It never looks
/// closer, which is what it gives up; buildConservativeCones opens the squares that matter.
///
/// The cones are for texel centres. Units, rounding, unlimited cones and `advance` are those of
/// buildConservativeCones.
textures::Plane buildQuickCones(const textures::DepthMap& map,
                                const std::function<void(std::size_t)>& advance = {});

}  // namespace relievo::preprocess
