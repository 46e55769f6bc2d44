#include "preprocess/depth_pyramid.h"

#include <algorithm>
#include <cassert>

namespace relievo::preprocess {
namespace {

textures::Plane halve(const textures::Plane& fine) {
    textures::Plane coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
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

DepthPyramid buildDepthPyramid(const textures::Plane& depth) {
    assert(depth.width > 0 && depth.height > 0);
    DepthPyramid pyramid;
    pyramid.levels.push_back(depth);
    while (pyramid.levels.back().width > 1 || pyramid.levels.back().height > 1)
        pyramid.levels.push_back(halve(pyramid.levels.back()));
    return pyramid;
}

}  // namespace relievo::preprocess
