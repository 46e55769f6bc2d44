#include "preprocess/cones_by_squares.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "tests/preprocess/cone_oracle.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

TEST(ConesBySquares, EqualBruteForceOverLiteralCopiesForEveryWrapMode) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] :
             {std::pair{1, 1}, {2, 1}, {1, 7}, {13, 1}, {3, 3}, {17, 11}, {32, 16}, {20, 29}})
            for (const int levels : {2, 9, 1 << 20}) {
                const DepthMap map = noiseMap(width, height, wrap, 7, levels);
                EXPECT_EQ(countWrongRatios(buildConesBySquares(map), map, 1), 0u)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << levels;
            }
}

// Smooth maps, where cones are wide and the search goes far.
TEST(ConesBySquares, EqualTheExactOnesOfEverySample) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        const DepthMap map = textures::generateSampleRelief(sample.name, 32, 24);
        EXPECT_EQ(countWrongRatios(buildConesBySquares(map), map, 1), 0u) << sample.name;
    }
}

// A map of texels half as high as wide has the distances of one with every second row left out.
TEST(ConesBySquares, FollowTheShapeOfTexels) {
    const DepthMap square = noiseMap(24, 40, WrapMode::Clamp, 4);
    DepthMap low{Plane(24, 79, 1.0f), WrapMode::Clamp, 0.5};
    for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 24; ++i)
            low.depth.at(i, 2 * j) = square.depth.at(i, j);
    const Plane expected = buildConesBySquares(square);
    const Plane ratio = buildConesBySquares(low);
    for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 24; ++i)
            ASSERT_EQ(ratio.at(i, 2 * j), expected.at(i, j)) << i << "," << j;
    DepthMap forgotten = low;
    forgotten.texelAspect = 1.0;
    EXPECT_NE(buildConesBySquares(forgotten).texels, ratio.texels);
}

TEST(ConesBySquares, AreCaughtWhenTheyForgetToRepeat) {
    DepthMap map = noiseMap(20, 29, WrapMode::Clamp, 7);
    const Plane ratio = buildConesBySquares(map);
    map.wrap = WrapMode::Repeat;
    EXPECT_GT(countWrongRatios(ratio, map, 1), 0u);
}

TEST(ConesBySquares, AreUnlimitedOnAFlatMap) {
    const Plane ratio = buildConesBySquares({Plane(9, 5, 0.5f), WrapMode::Repeat});
    EXPECT_EQ(*std::min_element(ratio.texels.begin(), ratio.texels.end()),
              std::numeric_limits<float>::infinity());
}

TEST(ConesBySquares, AreTheSameBytesForOneAndTwoThreadsAndSayHowFarTheyAre) {
    const DepthMap map = textures::generateSampleRelief("cobbles", 70, 50);
    std::atomic<std::size_t> done{0};
    const auto build = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return buildConesBySquares(map, [&](std::size_t texels) { done += texels; }).texels;
    };
    EXPECT_EQ(build(1), build(2));
    EXPECT_EQ(done, 2u * 70u * 50u);
}

}  // namespace
}  // namespace relievo::preprocess
