#include "preprocess/quick_cones.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "preprocess/cones_by_squares.h"
#include "tests/preprocess/cone_oracle.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

// How many cones are wider than the widest empty ones, or limited where those are not.
std::size_t countUnsafe(const Plane& ratio, const DepthMap& map) {
    const Plane exact = buildConesBySquares(map);
    std::size_t unsafe = 0;
    for (std::size_t k = 0; k < ratio.texels.size(); ++k)
        unsafe += ratio.texels[k] > exact.texels[k] ||
                          std::isinf(ratio.texels[k]) != std::isinf(exact.texels[k]) ||
                          ratio.texels[k] <= 0.0f
                      ? 1
                      : 0;
    return unsafe;
}

TEST(QuickCones, AreNeverWiderThanTheWidestEmptyOnes) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair{1, 1},
                                            {2, 1},
                                            {1, 7},
                                            {13, 1},
                                            {3, 3},
                                            {17, 11},
                                            {32, 16},
                                            {37, 53},
                                            {65, 9},
                                            {128, 2}})
            for (const int levels : {2, 9, 1 << 20}) {
                const DepthMap map = noiseMap(width, height, wrap, 7, levels);
                EXPECT_EQ(countUnsafe(buildQuickCones(map), map), 0u)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << levels;
            }
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        DepthMap map = textures::generateSampleRelief(sample.name, 60, 44);
        map.texelAspect = 0.9;
        EXPECT_EQ(countUnsafe(buildQuickCones(map), map), 0u) << sample.name;
    }
}

TEST(QuickCones, AreExactWhereNeighboursDecide) {
    for (const WrapMode wrap : kWraps) {
        const DepthMap map = noiseMap(3, 3, wrap, 2);
        EXPECT_EQ(countWrongRatios(buildQuickCones(map), map, 1), 0u) << wrapModeName(wrap);
    }
}

// The published loss: a third to three quarters of the cone is kept.
TEST(QuickCones, KeepAUsefulShareOfTheWidestOnes) {
    for (const char* const name : {"noise", "blocks", "wave"}) {
        const DepthMap map = textures::generateSampleRelief(name, 64, 64);
        const Plane quick = buildQuickCones(map);
        const Plane exact = buildConesBySquares(map);
        double share = 0.0;
        std::size_t limited = 0;
        for (std::size_t k = 0; k < quick.texels.size(); ++k)
            if (std::isfinite(exact.texels[k])) {
                share += quick.texels[k] / exact.texels[k];
                ++limited;
            }
        EXPECT_GT(share / static_cast<double>(limited), 0.3) << name;
    }
}

TEST(QuickCones, AreCaughtWhenTheyForgetToRepeat) {
    DepthMap map = noiseMap(37, 29, WrapMode::Clamp, 7);
    const Plane ratio = buildQuickCones(map);
    map.wrap = WrapMode::Repeat;
    EXPECT_GT(countUnsafe(ratio, map), 0u);
}

}  // namespace
}  // namespace relievo::preprocess
