#include "textures/depth_pyramid.h"

#include <algorithm>
#include <cassert>

namespace relievo::textures {
namespace {

Plane halve(const Plane& fine) {
    Plane coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
    for (int j = 0; j < coarse.height; ++j) {
        const int top = 2 * j;
        const int bottom = std::min(top + 1, fine.height - 1);
        for (int i = 0; i < coarse.width; ++i) {
            const int left = 2 * i;
            const int right = std::min(left + 1, fine.width - 1);
            coarse.at(i, j) = std::min({fine.at(left, top), fine.at(right, top),
                                        fine.at(left, bottom), fine.at(right, bottom)});
        }
    }
    return coarse;
}

}  // namespace

DepthPyramid buildDepthPyramid(const Plane& depth) {
    assert(depth.width > 0 && depth.height > 0);
    DepthPyramid pyramid;
    pyramid.levels.push_back(depth);
    while (pyramid.levels.back().width > 1 || pyramid.levels.back().height > 1)
        pyramid.levels.push_back(halve(pyramid.levels.back()));
    return pyramid;
}

Plane leastDepthsOfCells(const DepthMap& map) {
    Plane least(map.width(), map.height());
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i)
            least.at(i, j) =
                std::min({map.at(i, j), map.at(i + 1, j), map.at(i, j + 1), map.at(i + 1, j + 1)});
    return least;
}

}  // namespace relievo::textures
