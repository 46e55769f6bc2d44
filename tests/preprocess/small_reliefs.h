#pragma once

#include <cstdint>

#include "textures/depth_map.h"

namespace relievo::preprocess {

/// A map of noise: `levels` equally spaced depths in [0,1], the same on every machine.
textures::DepthMap noiseMap(int width, int height, textures::WrapMode wrap, std::uint32_t seed,
                            int levels = 1 << 20);

/// Smooth hills of about 15 texels. They do not fit the tile, so that every wrap mode has something
/// of its own at the borders.
textures::DepthMap hillMap(int width, int height, textures::WrapMode wrap,
                           double texelAspect = 1.0);

/// The tile with `copies` of it to each side, as DepthMap::at has them: (2·copies + 1)² tiles. The
/// wrap mode is that of the map.
textures::DepthMap mosaicOf(const textures::DepthMap& map, int copies);

}  // namespace relievo::preprocess
