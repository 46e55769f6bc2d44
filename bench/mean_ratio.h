#pragma once

#include <algorithm>

#include "textures/plane.h"

namespace relievo::bench {

/// The mean of the ratios of cones, tile widths per unit of depth. Those above 1 count as 1: a cone
/// that nothing limits has no other mean, and to a search it makes little difference.
inline double meanRatio(const textures::Plane& ratio) {
    double sum = 0.0;
    for (const float value : ratio.texels)
        sum += std::min(value, 1.0f);
    return sum / static_cast<double>(ratio.texels.size());
}

}  // namespace relievo::bench
