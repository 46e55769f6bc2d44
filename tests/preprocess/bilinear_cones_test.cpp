#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

#include "preprocess/bilinear_cones.h"
#include "preprocess/conservative_cones.h"
#include "tests/preprocess/sampled_cones.h"
#include "tests/preprocess/small_reliefs.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

// Long-range chords: one high texel far from all others limits every cone.
TEST(BilinearCones, OfASingleSpikeAreLimitedByIt) {
    DepthMap map{Plane(97, 61, 1.0f), WrapMode::Clamp};
    map.depth.at(11, 50) = 0.0f;
    const Plane ratio = buildConservativeCones(map, ConeGuarantee::Bilinear);
    for (const auto& [i, j] : {std::pair{90, 5}, {12, 0}, {40, 50}, {0, 60}}) {
        const double sampled = sampledRatio(map, i, j, conservativeSampling(map));
        EXPECT_LE(ratio.at(i, j), sampled);
        EXPECT_GE(ratio.at(i, j), 0.95 * sampled);
    }
}

// A stroke of a brush: a dent or a heap with noise on it.
Plane stroke(const DepthMap& map, int left, int top, int size, float by, unsigned seed) {
    std::mt19937 generator(seed);
    Plane depths(size, size);
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i)
            depths.at(i, j) = std::clamp(
                map.depth.at(left + i, top + j) + by * static_cast<float>(generator() % 256) / 255,
                0.0f, 1.0f);
    return depths;
}

TEST(BilinearCones, AfterAnEditAreBitForBitThoseOfANewBuild) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const char* name : {"noise", "pillars", "wave"}) {
            DepthMap map = textures::generateSampleRelief(name, 150, 130);
            map.wrap = wrap;
            BilinearCones cones(map);
            for (const auto& [left, top, by] :
                 {std::tuple{3, 100, -0.4f}, {140, 60, 0.3f}, {70, 1, -1.0f}, {70, 1, 1.0f}}) {
                cones.edit(left, top, stroke(cones.map(), left, top, 9, by, 4));
                const Plane anew = buildConservativeCones(cones.map(), ConeGuarantee::Bilinear);
                ASSERT_EQ(cones.ratio().texels, anew.texels)
                    << name << " " << wrapModeName(wrap) << " " << left << "," << top;
            }
        }
}

TEST(BilinearCones, AfterAnEditThatCannotReachFarAreMostlyKept) {
    BilinearCones cones(textures::generateSampleRelief("noise", 256, 256));
    const std::size_t built = cones.edit(100, 100, stroke(cones.map(), 100, 100, 8, 0.05f, 1));
    EXPECT_LT(built, 256u * 256u / 5u);
    EXPECT_GT(built, 8u * 8u);
    EXPECT_EQ(cones.edit(20, 20, stroke(cones.map(), 20, 20, 8, 0.0f, 1)), 0u);
}

}  // namespace
}  // namespace relievo::preprocess
