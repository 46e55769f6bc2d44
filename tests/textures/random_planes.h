#pragma once

#include <cstdint>
#include <random>

#include "textures/plane.h"

namespace relievo::textures {

/// Random samples in [low,high), the same in every run.
inline Plane randomPlane(int width, int height, float low, float high, std::uint32_t seed) {
    std::mt19937 generator(seed);
    Plane plane(width, height);
    for (float& value : plane.texels)
        value = low +
                (high - low) * static_cast<float>(static_cast<double>(generator()) / 4294967296.0);
    return plane;
}

}  // namespace relievo::textures
