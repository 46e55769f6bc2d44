#include "tests/preprocess/small_reliefs.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace relievo::preprocess {

using textures::DepthMap;

DepthMap noiseMap(int width, int height, textures::WrapMode wrap, std::uint32_t seed, int levels) {
    std::mt19937 generator(seed);
    DepthMap map{textures::Plane(width, height), wrap};
    for (float& depth : map.depth.texels)
        depth = static_cast<float>(generator() % static_cast<std::uint32_t>(levels)) /
                static_cast<float>(std::max(levels - 1, 1));
    return map;
}

DepthMap hillMap(int width, int height, textures::WrapMode wrap, double texelAspect) {
    DepthMap map{textures::Plane(width, height), wrap, texelAspect};
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            map.depth.at(i, j) =
                static_cast<float>(0.5 + 0.45 * std::sin(0.4 * i + 0.2) * std::cos(0.5 * j));
    return map;
}

DepthMap mosaicOf(const DepthMap& map, int copies) {
    const int tiles = 2 * copies + 1;
    DepthMap mosaic{textures::Plane(tiles * map.width(), tiles * map.height()), map.wrap,
                    map.texelAspect};
    for (int j = 0; j < mosaic.height(); ++j)
        for (int i = 0; i < mosaic.width(); ++i)
            mosaic.depth.at(i, j) = map.at(i - copies * map.width(), j - copies * map.height());
    return mosaic;
}

}  // namespace relievo::preprocess
