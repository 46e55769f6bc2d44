#include "tests/preprocess/cone_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo::preprocess {
namespace {

using textures::DepthMap;

// Over a mosaic of copies, so that the inner loop is plain.
double leastSquaredRatio(const textures::Plane& depth, int i, int j) {
    const double apex = depth.at(i, j);
    double least = std::numeric_limits<double>::infinity();
    for (int y = 0; y < depth.height; ++y) {
        const float* const row = depth.texels.data() + depth.index(0, y);
        for (int x = 0; x < depth.width; ++x) {
            const double difference = apex - row[x];
            const double across = x - i;
            const double down = y - j;
            const double squared = (across * across + down * down) / (difference * difference);
            least = difference > 0.0 ? std::min(least, squared) : least;
        }
    }
    return least;
}

}  // namespace

double bruteForceRatio(const DepthMap& map, int i, int j, int copies) {
    const DepthMap mosaic = mosaicOf(map, copies);
    return std::sqrt(leastSquaredRatio(mosaic.depth, i + copies * map.width(),
                                       j + copies * map.height())) /
           map.width();
}

bool isTrueRatio(float ratio, double truth) {
    if (std::isinf(truth) || std::isinf(ratio))
        return std::isinf(truth) && std::isinf(ratio);
    if (truth > std::numeric_limits<float>::max())
        return ratio == std::numeric_limits<float>::max();
    return ratio <= truth && ratio >= truth * (1.0 - 2e-6);
}

std::size_t countWrongRatios(const textures::Plane& ratio, const DepthMap& map, int copies) {
    const DepthMap mosaic = mosaicOf(map, copies);
    std::size_t wrong = 0;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i) {
            const double truth = std::sqrt(leastSquaredRatio(mosaic.depth, i + copies * map.width(),
                                                             j + copies * map.height())) /
                                 map.width();
            wrong += isTrueRatio(ratio.at(i, j), truth) ? 0 : 1;
        }
    return wrong;
}

}  // namespace relievo::preprocess
