#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "textures/plane.h"

namespace relievo::textures {

/// Red, green and blue of the albedo that goes with generateSampleRelief of the same arguments,
/// sRGB in [0,1]. Throws like that function.
std::array<Plane, 3> generateSampleAlbedo(std::string_view name, int width, int height,
                                          std::uint32_t seed = 1);

}  // namespace relievo::textures
