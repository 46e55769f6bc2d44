#include "preprocess/cones_by_squares.h"

#include <gtest/gtest.h>

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

TEST(ConesBySquares, OfSomeTexelsAreThoseOfAllTexels) {
    const DepthMap map = noiseMap(13, 20, WrapMode::Repeat, 2);
    const Plane all = buildConesBySquares(map);
    for (const int step : {2, 3, 7, 20, 21}) {
        const Plane some = buildConesBySquares(map, {}, step);
        ASSERT_EQ(some.width, (13 + step - 1) / step);
        ASSERT_EQ(some.height, (20 + step - 1) / step);
        for (int j = 0; j < some.height; ++j)
            for (int i = 0; i < some.width; ++i)
                EXPECT_EQ(some.at(i, j), all.at(i * step, j * step))
                    << step << " " << i << " " << j;
    }
}

TEST(ConesBySquares, AreCaughtWhenTheyForgetToRepeat) {
    DepthMap map = noiseMap(20, 29, WrapMode::Clamp, 7);
    const Plane ratio = buildConesBySquares(map);
    map.wrap = WrapMode::Repeat;
    EXPECT_GT(countWrongRatios(ratio, map, 1), 0u);
}

}  // namespace
}  // namespace relievo::preprocess
