#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// A texel at which a field may be no higher than `most`.
struct StepBound {
    glm::ivec2 texel{0};
    double most = 0.0;
};

/// Lowers `distance`, true distances in texels, which differ between two texel centres by at most
/// the way between them, to the highest field that does so too and keeps to all bounds:
///
///   s(p) = min(distance(p), min over bounds b of b.most + |p − b.texel|).
///
/// Each group of bounds is of texels near each other, as those of one corner: it costs the texels
/// that it lowers, and some around, times its bounds. Under repeat the way is that to the nearest
/// copy.
void lowerToBounds(textures::Plane& distance, textures::WrapMode wrap,
                   const std::vector<std::vector<StepBound>>& groups);

}  // namespace relievo::preprocess
