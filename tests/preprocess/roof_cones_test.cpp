#include "preprocess/roof_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/guarantee_check.h"
#include "tests/preprocess/small_reliefs.h"
#include "tests/preprocess/thread_limit.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

reference::RoofMap roofMapOf(const std::vector<RoofConeLayer>& layers, int block) {
    reference::RoofMap map;
    map.block = block;
    for (const RoofConeLayer& layer : layers)
        map.layers.push_back({layer.roof, layer.ratio});
    return map;
}

std::uint64_t violations(const DepthMap& map, const RoofConeRules& rules, double widen = 1.0) {
    std::vector<RoofConeLayer> layers = buildRoofCones(map, rules);
    for (RoofConeLayer& layer : layers)
        for (float& ratio : layer.ratio.texels)
            ratio *= static_cast<float>(widen);
    reference::GuaranteeCheckOptions options;
    options.rays = 20'000;
    return reference::checkRoofs(map, roofMapOf(layers, rules.block), options).violations;
}

TEST(RoofCones, AreSafeInEverySectorWrapModeAndShape) {
    for (const WrapMode wrap : kWraps)
        for (const int sectors : {1, 4, 8})
            for (const auto& [width, height] :
                 {std::pair{1, 1}, {2, 1}, {1, 7}, {3, 3}, {64, 1}, {17, 11}, {20, 53}}) {
                const DepthMap map = noiseMap(width, height, wrap, 7);
                EXPECT_EQ(violations(map, {.sectors = sectors}), 0u)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << sectors;
            }
}

// As MIP levels have them: the places of rows are no round numbers then. Rays along the rows of
// texel centres pass between cells.
TEST(RoofCones, AreSafeWhereTexelsAreNotSquare) {
    for (const double aspect : {0.7, 1.02, 1.4})
        for (const int sectors : {1, 4, 8}) {
            DepthMap map = noiseMap(12, 8, WrapMode::Repeat, 5);
            map.texelAspect = aspect;
            EXPECT_EQ(violations(map, {.sectors = sectors}), 0u) << aspect << " " << sectors;
        }
}

// The small MIP levels of long maps have texels that are many times as high as wide, or the other
// way round.
TEST(RoofCones, AreSafeWhereTexelsAreThin) {
    for (const auto& [width, height] : {std::pair{16, 1}, {1, 16}, {12, 8}})
        for (const double aspect : {0.05, 0.2, 5.0, 20.0})
            for (const int sectors : {1, 4, 8}) {
                DepthMap map = noiseMap(width, height, WrapMode::Repeat, 5);
                map.texelAspect = aspect;
                EXPECT_EQ(violations(map, {.sectors = sectors}), 0u)
                    << width << "x" << height << " " << aspect << " " << sectors;
            }
}

TEST(RoofCones, AreSafeOnEverySample) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs())
        for (const int sectors : {1, 4, 8}) {
            const DepthMap map = textures::generateSampleRelief(sample.name, 61, 83);
            EXPECT_EQ(violations(map, {.sectors = sectors, .block = 1 + sectors % 3}), 0u)
                << sample.name << " " << sectors;
        }
}

// The wrong variant: cones that are a little wider.
TEST(RoofCones, AreCaughtWhenTheyAreWider) {
    for (const int sectors : {1, 4}) {
        const DepthMap map = noiseMap(40, 40, WrapMode::Repeat, 3);
        EXPECT_GT(violations(map, {.sectors = sectors}, 1.5), 0u);
    }
}

// Between rectangles, by brute force: no wider cone is safe for a cell whose corners are tried.
double ratioFromCorners(const DepthMap& map, const Plane& roof, int i, int j, int signX, int signY,
                        int block) {
    double least = kInfinity;
    for (int y = -map.height(); y < 2 * map.height(); ++y)
        for (int x = -map.width(); x < 2 * map.width(); ++x) {
            const double across = std::max({0, i - x, x - i - 1});
            const double down = std::max({0, j - y, y - j - 1});
            const bool ahead = (signX == 0 || signX * (x - i - 0.5) > 0.0) &&
                               (signY == 0 || signY * (y - j - 0.5) > 0.0);
            const double difference = static_cast<double>(roof.at(i, j)) - map.at(x, y);
            if (ahead && difference > 0.0 && std::max(across, down) > block)
                least = std::min(least, std::hypot(across, down) / difference / map.width());
        }
    return least;
}

TEST(RoofCones, AreNearlyAsWideAsTheSamplesAllow) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        const DepthMap map = textures::generateSampleRelief(sample.name, 48, 40);
        for (const int sectors : {1, 4}) {
            const std::vector<RoofConeLayer> layers = buildRoofCones(map, {.sectors = sectors});
            double built = 0.0;
            double allowed = 0.0;
            for (int j = 0; j < map.height(); j += 3)
                for (int i = 0; i < map.width(); i += 3) {
                    const int sign = sectors == 1 ? 0 : 1;
                    const double truth = ratioFromCorners(map, layers[0].roof, i, j, sign, sign, 1);
                    EXPECT_LE(layers[0].ratio.at(i, j), truth);
                    built += std::min(1.0, static_cast<double>(layers[0].ratio.at(i, j)));
                    allowed += std::min(1.0, truth);
                }
            EXPECT_GE(built, 0.9 * allowed) << sample.name << " " << sectors;
        }
    }
}

TEST(RoofCones, RoofsAreTheLeastDepthsOfTheBlocks) {
    const DepthMap map = noiseMap(13, 9, WrapMode::Mirror, 1);
    const Plane all = buildRoofCones(map, {.sectors = 1, .block = 2})[0].roof;
    const Plane behind = buildRoofCones(map, {.sectors = 4, .block = 2})[3].roof;
    for (int j = 0; j < 9; ++j)
        for (int i = 0; i < 13; ++i) {
            float around = 1.0f;
            float toTheLeftAndUp = 1.0f;
            for (int y = -2; y <= 3; ++y)
                for (int x = -2; x <= 3; ++x) {
                    around = std::min(around, map.at(i + x, j + y));
                    if (x <= 1 && y <= 1)
                        toTheLeftAndUp = std::min(toTheLeftAndUp, map.at(i + x, j + y));
                }
            EXPECT_EQ(all.at(i, j), around);
            EXPECT_EQ(behind.at(i, j), toTheLeftAndUp);
        }
}

TEST(RoofCones, OfARepeatedMapAreExactlyTheCropOfItsMosaic) {
    const DepthMap map = textures::generateSampleRelief("spikes", 29, 23);
    DepthMap mosaic{Plane(4 * 29, 4 * 23), WrapMode::Repeat};
    for (int j = 0; j < mosaic.height(); ++j)
        for (int i = 0; i < mosaic.width(); ++i)
            mosaic.depth.at(i, j) = map.at(i, j);
    for (const int sectors : {1, 4, 8}) {
        const auto tile = buildRoofCones(map, {.sectors = sectors});
        const auto whole = buildRoofCones(mosaic, {.sectors = sectors});
        for (std::size_t k = 0; k < tile.size(); ++k)
            for (int j = 0; j < 23; ++j)
                for (int i = 0; i < 29; ++i)
                    ASSERT_EQ(tile[k].ratio.at(i, j), 4.0f * whole[k].ratio.at(29 + i, 23 + j))
                        << sectors << " sectors, " << k << ": " << i << "," << j;
    }
}

TEST(RoofCones, AreTheSameBytesForOneAndTwoThreadsAndSayHowFarTheyAre) {
    const DepthMap map = textures::generateSampleRelief("noise", 100, 70);
    std::vector<std::vector<float>> ratios;
    std::atomic<std::size_t> done{0};
    for (const std::size_t threads : {1u, 2u}) {
        ratios.push_back(onThreads(threads, [&] {
            return buildRoofCones(map, {.sectors = 4}, [&](std::size_t cells) { done += cells; })[2]
                .ratio.texels;
        }));
    }
    EXPECT_EQ(ratios[0], ratios[1]);
    EXPECT_EQ(done, 2u * 4u * 100u * 70u);
}

TEST(RoofCones, AreUnlimitedWhereNothingIsHigher) {
    const DepthMap flat{Plane(19, 5, 0.5f), WrapMode::Repeat};
    for (const RoofConeLayer& layer : buildRoofCones(flat, {.sectors = 4})) {
        EXPECT_TRUE(std::ranges::all_of(layer.roof.texels, [](float d) { return d == 0.5f; }));
        EXPECT_TRUE(std::ranges::all_of(layer.ratio.texels, [](float c) { return std::isinf(c); }));
    }
}

}  // namespace
}  // namespace relievo::preprocess
