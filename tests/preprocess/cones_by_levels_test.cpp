#include "preprocess/cones_by_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "preprocess/conservative_cones.h"
#include "tests/preprocess/cone_oracle.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

TEST(ConesByLevels, AreExactWithALevelForEachDepth) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair{1, 1}, {1, 13}, {37, 23}, {48, 2}}) {
            const DepthMap map = noiseMap(width, height, wrap, 3, 40);
            EXPECT_EQ(countWrongRatios(buildConesByLevels(map), map, 1), 0u)
                << width << "x" << height << " " << wrapModeName(wrap);
        }
}

TEST(ConesByLevels, AreNarrowerThanExactOnesNeverWiderWithFewerLevels) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        const DepthMap map = textures::generateSampleRelief(sample.name, 64, 48);
        const Plane exact = buildConservativeCones(map, ConeGuarantee::Texel);
        for (const int levels : {1, 2, 16}) {
            const Plane ratio = buildConesByLevels(map, levels);
            for (std::size_t k = 0; k < ratio.texels.size(); ++k) {
                ASSERT_LE(ratio.texels[k], exact.texels[k] * (1.0f + 3e-6f))
                    << sample.name << " " << levels;
                ASSERT_GT(ratio.texels[k], 0.0f) << sample.name << " " << levels;
            }
        }
    }
}

// What the test above must notice: with classes counted as deep as their deepest texel, as plain
// quantisation does, cones get wider than they may.
TEST(ConesByLevels, OfAQuantisedMapAreUnsafeForTheTrueOne) {
    const DepthMap map = noiseMap(32, 32, WrapMode::Repeat, 9);
    DepthMap quantised = map;
    for (float& depth : quantised.depth.texels)
        depth = std::nearbyint(depth * 15.0f) / 15.0f;
    const Plane exact = buildConservativeCones(map, ConeGuarantee::Texel);
    const Plane ratio = buildConesByLevels(quantised);
    std::size_t wider = 0;
    for (std::size_t k = 0; k < ratio.texels.size(); ++k)
        wider += ratio.texels[k] > exact.texels[k] * (1.0f + 3e-6f) ? 1 : 0;
    EXPECT_GT(wider, 0u);
}

}  // namespace
}  // namespace relievo::preprocess
