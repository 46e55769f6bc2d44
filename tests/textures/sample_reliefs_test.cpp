#include "textures/sample_reliefs.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "temporary_folder.h"
#include "textures/content_hash.h"
#include "textures/sample_albedo.h"

namespace relievo::textures {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> sampleNames() {
    std::vector<std::string> names;
    for (const SampleRelief& relief : sampleReliefs())
        names.emplace_back(relief.name);
    return names;
}

class EverySample : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Samples, EverySample, testing::ValuesIn(sampleNames()),
                         [](const auto& sample) { return sample.param; });

TEST(SampleReliefs, AreTheTen) {
    EXPECT_THAT(sampleNames(), ElementsAre("noise", "cobbles", "bricks", "blocks", "pillars",
                                           "spikes", "ridge", "hemispheres", "wave", "lettering"));
}

TEST_P(EverySample, UsesTheRangeOfDepths) {
    for (const std::uint32_t seed : {1u, 2u, 12345u}) {
        const DepthMap map = generateSampleRelief(GetParam(), 128, 128, seed);
        const auto [low, high] =
            std::minmax_element(map.depth.texels.begin(), map.depth.texels.end());
        EXPECT_GE(*low, 0.0f);
        EXPECT_LE(*high, 1.0f);
        EXPECT_LT(*low, 0.16f);
        EXPECT_GT(*high, 0.84f);
    }
}

/// The largest steps between neighbours in each direction: over the seam, and anywhere else.
struct Steps {
    float seam = 0.0f;
    float inside = 0.0f;
};

Steps stepsOf(const DepthMap& map) {
    Steps steps;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i) {
            float& horizontal = i == 0 ? steps.seam : steps.inside;
            float& vertical = j == 0 ? steps.seam : steps.inside;
            horizontal = std::max(horizontal, std::abs(map.at(i, j) - map.at(i - 1, j)));
            vertical = std::max(vertical, std::abs(map.at(i, j) - map.at(i, j - 1)));
        }
    return steps;
}

TEST_P(EverySample, RepeatsWithoutASeam) {
    for (const auto& [width, height] : {std::array{256, 256}, std::array{256, 128}}) {
        const Steps steps = stepsOf(generateSampleRelief(GetParam(), width, height, 3));
        EXPECT_LE(steps.seam, 1.25f * steps.inside);
    }
}

TEST(SampleReliefs, TheSeamCheckSeesASeam) {
    DepthMap ramp{Plane(64, 64), WrapMode::Repeat};
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i)
            ramp.depth.at(i, j) = static_cast<float>(i) / 63.0f;
    const Steps steps = stepsOf(ramp);
    EXPECT_GT(steps.seam, 1.25f * steps.inside);
}

TEST_P(EverySample, IsTheSameEveryTime) {
    EXPECT_EQ(generateSampleRelief(GetParam(), 61, 47, 7).depth.texels,
              generateSampleRelief(GetParam(), 61, 47, 7).depth.texels);
}

TEST_P(EverySample, TakesAnySize) {
    for (const auto& [width, height] : {std::array{1, 1}, std::array{1, 64}, std::array{64, 1},
                                        std::array{127, 31}, std::array{3, 192}}) {
        const DepthMap map = generateSampleRelief(GetParam(), width, height, 5);
        ASSERT_EQ(map.width(), width);
        ASSERT_EQ(map.height(), height);
        EXPECT_TRUE(std::all_of(map.depth.texels.begin(), map.depth.texels.end(),
                                [](float depth) { return depth >= 0.0f && depth <= 1.0f; }));
    }
}

TEST_P(EverySample, HasAnAlbedoOfColours) {
    const std::array<Plane, 3> albedo = generateSampleAlbedo(GetParam(), 64, 32, 2);
    for (const Plane& plane : albedo) {
        ASSERT_EQ(plane.width, 64);
        ASSERT_EQ(plane.height, 32);
        EXPECT_TRUE(std::all_of(plane.texels.begin(), plane.texels.end(),
                                [](float value) { return value >= 0.0f && value <= 1.0f; }));
    }
    EXPECT_NE(albedo[0].texels, albedo[2].texels);
}

TEST(SampleReliefs, SeedsDiffer) {
    for (const char* name : {"noise", "cobbles", "bricks", "blocks", "pillars", "spikes"})
        EXPECT_NE(generateSampleRelief(name, 64, 64, 1).depth.texels,
                  generateSampleRelief(name, 64, 64, 2).depth.texels)
            << name;
}

TEST(SampleReliefs, TheWaveIsItsFormula) {
    const DepthMap map = generateSampleRelief("wave", 48, 96);
    for (int j = 0; j < 96; ++j)
        for (int i = 0; i < 48; ++i) {
            const double x = 2.0 * std::numbers::pi * (i + 0.5) / 48.0;
            const double y = 2.0 * std::numbers::pi * (j + 0.5) / 96.0;
            EXPECT_NEAR(map.at(i, j),
                        0.5 + 0.24 * std::sin(x + 2.0 * y) + 0.24 * std::cos(2.0 * x - y), 1e-7);
        }
}

TEST(SampleReliefs, TheCrestOfTheRidgeSlopes) {
    const DepthMap map = generateSampleRelief("ridge", 256, 256);
    const auto crest = [&](int i) {
        float least = 1.0f;
        for (int j = 0; j < 256; ++j)
            least = std::min(least, map.at(i, j));
        return least;
    };
    EXPECT_LT(crest(128), 0.1f);
    EXPECT_GT(crest(0), 0.6f);
    for (int i = 8; i < 120; ++i)
        EXPECT_LT(crest(i), crest(i - 1)) << "up to the summit without a level stretch";
}

TEST(SampleReliefs, HemispheresAreRound) {
    const DepthMap map = generateSampleRelief("hemispheres", 512, 512);
    // The ball of the first row whose axis is at (1/16, 1/8), of radius 0.11.
    for (const double r : {0.0, 0.25, 0.5, 0.75, 0.9}) {
        const int i = static_cast<int>(512.0 * (1.0 / 16.0 + 0.11 * r));
        const double dx = ((i + 0.5) / 512.0 - 1.0 / 16.0) / 0.11;
        const double dy = (64.5 / 512.0 - 1.0 / 8.0) / 0.11;
        EXPECT_NEAR(map.at(i, 64), 1.0 - std::sqrt(1.0 - dx * dx - dy * dy), 1e-6);
    }
}

TEST(SampleReliefs, BlocksAreLevelWithVerticalWalls) {
    const DepthMap map = generateSampleRelief("blocks", 128, 128);
    int level = 0;
    for (int j = 0; j < 128; ++j)
        for (int i = 0; i < 128; ++i)
            level += map.at(i, j) == map.at(i + 1, j) ? 1 : 0;
    EXPECT_GT(level, 128 * 128 * 4 / 5);
    EXPECT_LT(level, 128 * 128);
}

TEST(SampleReliefs, BadArgumentsAreNamed) {
    EXPECT_THAT(errorOf([] { generateSampleRelief("gravel", 8, 8); }),
                HasSubstr("no sample relief is called 'gravel', expected one of noise, cobbles"));
    EXPECT_THAT(errorOf([] { generateSampleRelief("noise", 0, 8); }), HasSubstr("0 x 8 texels"));
    EXPECT_THAT(errorOf([] { generateSampleAlbedo("noise", 8, -1); }), HasSubstr("8 x -1 texels"));
    EXPECT_THAT(errorOf([] { generateSampleAlbedo("gravel", 8, 8); }), HasSubstr("'gravel'"));
}

}  // namespace
}  // namespace relievo::textures
