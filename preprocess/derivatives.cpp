#include "preprocess/derivatives.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace relievo::preprocess {
namespace {

void differentiateRow(const textures::DepthMap& map, int j, Derivatives& derivatives) {
    const double acrossScale = 0.5 * map.width();
    const double downScale = acrossScale / map.texelAspect;
    for (int i = 0; i < map.width(); ++i) {
        const double across = static_cast<double>(map.at(i + 1, j)) - map.at(i - 1, j);
        const double down = static_cast<double>(map.at(i, j + 1)) - map.at(i, j - 1);
        derivatives.dx.at(i, j) = static_cast<float>(across * acrossScale);
        derivatives.dy.at(i, j) = static_cast<float>(down * downScale);
    }
}

}  // namespace

Derivatives buildDerivatives(const textures::DepthMap& map) {
    Derivatives derivatives{textures::Plane(map.width(), map.height()),
                            textures::Plane(map.width(), map.height())};
    tbb::parallel_for(tbb::blocked_range<int>(0, map.height()),
                      [&](const tbb::blocked_range<int>& rows) {
                          for (int j = rows.begin(); j < rows.end(); ++j)
                              differentiateRow(map, j, derivatives);
                      });
    return derivatives;
}

}  // namespace relievo::preprocess
