#include "preprocess/dilation_erosion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

#include "tests/preprocess/small_reliefs.h"
#include "tests/preprocess/thread_limit.h"
#include "textures/bilinear.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

std::size_t countWrong(const DepthExtrema& extrema, const DepthMap& map, int reach) {
    std::size_t wrong = 0;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i) {
            float least = map.depth.at(i, j);
            float greatest = least;
            for (int y = j - reach; y <= j + reach; ++y)
                for (int x = i - reach; x <= i + reach; ++x) {
                    least = std::min(least, map.at(x, y));
                    greatest = std::max(greatest, map.at(x, y));
                }
            wrong += extrema.least.at(i, j) != least || extrema.greatest.at(i, j) != greatest;
        }
    return wrong;
}

TEST(DilationErosion, EqualBruteForce) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 9}, {10, 1}, {2, 2}, {17, 13}, {31, 24}, {65, 3}, {130, 5}})
            for (const int reach : {0, 1, 2, 5, 12}) {
                const DepthMap map = noiseMap(width, height, wrap, 5);
                EXPECT_EQ(countWrong(findDepthExtrema(map, reach), map, reach), 0u)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << reach;
            }
}

TEST(DilationErosion, BoundTheBilinearSurfaceAroundTexelCentres) {
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> offset(-2.0, 2.0);
    for (const WrapMode wrap : kWraps) {
        const DepthMap map = noiseMap(19, 12, wrap, 6);
        const DepthExtrema extrema = findDepthExtrema(map, 2);
        for (int j = 0; j < 12; ++j)
            for (int i = 0; i < 19; ++i)
                for (int k = 0; k < 20; ++k) {
                    const double depth =
                        sampleBilinear(map.depth, (i + 0.5 + offset(generator)) / 19,
                                       (j + 0.5 + offset(generator)) / 12, wrap);
                    ASSERT_GE(depth, extrema.least.at(i, j) - 1e-12);
                    ASSERT_LE(depth, extrema.greatest.at(i, j) + 1e-12);
                }
    }
}

TEST(DilationErosion, AreCaughtWithAWrongWrapModeOrReach) {
    DepthMap map = noiseMap(17, 13, WrapMode::Clamp, 5);
    const DepthExtrema extrema = findDepthExtrema(map, 2);
    EXPECT_GT(countWrong(extrema, map, 1), 0u);
    map.wrap = WrapMode::Repeat;
    EXPECT_GT(countWrong(extrema, map, 2), 0u);
}

TEST(DilationErosion, AreTheSameForOneAndTwoThreads) {
    const DepthMap map = noiseMap(200, 90, WrapMode::Mirror, 5);
    const auto build = [&] { return findDepthExtrema(map, 4); };
    const DepthExtrema one = onThreads(1, build);
    const DepthExtrema two = onThreads(2, build);
    EXPECT_EQ(one.least.texels, two.least.texels);
    EXPECT_EQ(one.greatest.texels, two.greatest.texels);
}

}  // namespace
}  // namespace relievo::preprocess
