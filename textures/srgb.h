#pragma once

#include <cmath>

namespace relievo::textures {

/// The light of a value encoded as sRGB, both in [0,1] (IEC 61966-2-1).
inline double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// The inverse.
inline double srgbFromLinear(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

}  // namespace relievo::textures
