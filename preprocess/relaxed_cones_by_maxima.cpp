#include "preprocess/relaxed_cones_by_maxima.h"

#include "preprocess/cones_by_levels.h"

namespace relievo::preprocess {
namespace {

bool isLocalMaximum(const textures::DepthMap& map, int i, int j) {
    for (int y = j - 1; y <= j + 1; ++y)
        for (int x = i - 1; x <= i + 1; ++x)
            if (map.at(x, y) < map.depth.at(i, j))
                return false;
    return true;
}

}  // namespace

std::vector<std::uint8_t> markLocalMaxima(const textures::DepthMap& map) {
    std::vector<std::uint8_t> maxima(map.depth.texels.size());
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i)
            maxima[map.depth.index(i, j)] = isLocalMaximum(map, i, j) ? 1 : 0;
    return maxima;
}

textures::Plane buildRelaxedConesByMaxima(const textures::DepthMap& map, int levels,
                                          const std::function<void(std::size_t)>& advance) {
    return buildConesToTexels(map, markLocalMaxima(map), levels, advance);
}

}  // namespace relievo::preprocess
