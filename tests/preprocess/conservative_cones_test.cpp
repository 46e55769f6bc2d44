#include "preprocess/conservative_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "preprocess/round_down.h"
#include "tests/preprocess/cone_oracle.h"
#include "tests/preprocess/thread_limit.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr ConeGuarantee kGuarantees[] = {ConeGuarantee::Texel, ConeGuarantee::Bilinear};
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(ConservativeCones, EqualBruteForceOverLiteralCopiesForEveryWrapMode) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] :
             {std::pair{1, 1}, {2, 1}, {1, 7}, {13, 1}, {3, 3}, {17, 11}, {32, 16}, {20, 29}})
            for (const int levels : {2, 9, 1 << 20}) {
                const DepthMap map = noiseMap(width, height, wrap, 7, levels);
                EXPECT_EQ(
                    countWrongRatios(buildConservativeCones(map, ConeGuarantee::Texel), map, 1), 0u)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << levels;
            }
}

TEST(ConservativeCones, EqualBruteForceOnOddAndLongMaps) {
    for (const auto& [width, height] :
         {std::pair{37, 53}, {101, 1}, {1, 127}, {256, 4}, {3, 192}, {67, 65}}) {
        const DepthMap map = noiseMap(width, height, WrapMode::Clamp, 11);
        EXPECT_EQ(countWrongRatios(buildConservativeCones(map, ConeGuarantee::Texel), map, 0), 0u)
            << width << "x" << height;
    }
}

TEST(ConservativeCones, EqualBruteForceOnEverySample) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        DepthMap map = textures::generateSampleRelief(sample.name, 64, 64);
        map.wrap = WrapMode::Mirror;
        EXPECT_EQ(countWrongRatios(buildConservativeCones(map, ConeGuarantee::Texel), map, 0), 0u)
            << sample.name;
    }
}

// Single apexes against the whole of a larger map, as it is baked.
TEST(ConservativeCones, EqualBruteForceAtRandomTexelsOfARepeatedSample) {
    for (const char* name : {"noise", "ridge", "wave", "cobbles"}) {
        const DepthMap map = textures::generateSampleRelief(name, 160, 96);
        const Plane ratio = buildConservativeCones(map, ConeGuarantee::Texel);
        std::mt19937 generator(3);
        for (int k = 0; k < 40; ++k) {
            const int i = static_cast<int>(generator() % 160);
            const int j = static_cast<int>(generator() % 96);
            EXPECT_TRUE(isTrueRatio(ratio.at(i, j), bruteForceRatio(map, i, j, 1)))
                << name << " " << i << "," << j << ": " << ratio.at(i, j);
        }
    }
}

// Four tiles a side, not three: ratios are per tile width, and a power of two scales floats
// exactly.
TEST(ConservativeCones, OfARepeatedMapAreExactlyTheCropOfItsMosaic) {
    for (const ConeGuarantee guarantee : kGuarantees)
        for (const auto& [name, width, height] :
             {std::tuple{"blocks", 48, 40}, {"noise", 53, 31}, {"spikes", 80, 7}}) {
            const DepthMap map = textures::generateSampleRelief(name, width, height);
            DepthMap mosaic{Plane(4 * width, 4 * height), WrapMode::Clamp};
            for (int j = 0; j < mosaic.height(); ++j)
                for (int i = 0; i < mosaic.width(); ++i)
                    mosaic.depth.at(i, j) = map.at(i, j);
            const Plane tile = buildConservativeCones(map, guarantee);
            const Plane whole = buildConservativeCones(mosaic, guarantee);
            for (int j = 0; j < height; ++j)
                for (int i = 0; i < width; ++i)
                    ASSERT_EQ(tile.at(i, j), 4.0f * whole.at(width + i, height + j))
                        << name << " " << i << "," << j;
        }
}

TEST(ConservativeCones, AreTheSameBytesAndTheSameWorkForOneAndTwoThreads) {
    const DepthMap map = textures::generateSampleRelief("noise", 200, 150);
    for (const ConeGuarantee guarantee : kGuarantees) {
        std::vector<Plane> ratios;
        std::vector<SlopeSearchStatistics> work(2);
        for (const std::size_t threads : {1u, 2u}) {
            ratios.push_back(onThreads(threads, [&] {
                return buildConservativeCones(map, guarantee, {}, &work[threads - 1]);
            }));
        }
        EXPECT_EQ(ratios[0].texels, ratios[1].texels);
        EXPECT_EQ(work[0].nodes, work[1].nodes);
        EXPECT_EQ(work[0].samples, work[1].samples);
        EXPECT_GT(work[0].nodes, 0u);
    }
}

TEST(ConservativeCones, AreUnlimitedWhereNothingIsHigher) {
    const DepthMap flat{Plane(19, 5, 0.5f), WrapMode::Repeat};
    for (const float ratio : buildConservativeCones(flat, ConeGuarantee::Texel).texels)
        EXPECT_EQ(ratio, kInfinity);
    DepthMap spike = flat;
    spike.depth.at(9, 2) = 0.0f;
    const Plane ratio = buildConservativeCones(spike, ConeGuarantee::Texel);
    EXPECT_EQ(ratio.at(9, 2), kInfinity);
    EXPECT_TRUE(isTrueRatio(ratio.at(10, 2), 1.0 / 19 / 0.5));
}

TEST(ConservativeCones, SurviveDifferencesAtTheEndsOfFloat) {
    const float least = std::numeric_limits<float>::denorm_min();
    DepthMap map{Plane(3, 1), WrapMode::Clamp};
    map.depth.texels = {0.0f, least, 1.0f};
    const Plane ratio = buildConservativeCones(map, ConeGuarantee::Texel);
    EXPECT_EQ(ratio.at(0, 0), kInfinity);
    EXPECT_EQ(ratio.at(1, 0), std::numeric_limits<float>::max());
    EXPECT_TRUE(isTrueRatio(ratio.at(2, 0), 1.0 / 3));
}

// A search in growing squares that stops too early, as algorithm 3.2 prints it (E5): on the
// difference of depth with the best candidate, instead of the largest one possible.
Plane conesByGrowingSquares(const DepthMap& map, bool stopsAsPrinted) {
    Plane ratio(map.width(), map.height(), kInfinity);
    const auto tryTexel = [&](int i, int j, int x, int y, double& best, double& difference) {
        if (x < 0 || y < 0 || x >= map.width() || y >= map.height())
            return;
        const double lower = static_cast<double>(map.depth.at(i, j)) - map.depth.at(x, y);
        const double candidate = std::hypot(x - i, y - j) / lower;
        if (lower > 0.0 && candidate < best) {
            best = candidate;
            difference = lower;
        }
    };
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i) {
            double best = kInfinity;
            double difference = 1.0;
            for (int radius = 1; radius < std::max(map.width(), map.height()); ++radius) {
                if (radius >= best * (stopsAsPrinted ? difference : map.depth.at(i, j)))
                    break;
                for (int k = -radius; k <= radius; ++k)
                    for (const auto& [x, y] :
                         {std::pair{k, -radius}, {k, radius}, {-radius, k}, {radius, k}})
                        tryTexel(i, j, i + x, j + y, best, difference);
            }
            ratio.at(i, j) = roundDown(belowRounding(best / map.width()));
        }
    return ratio;
}

TEST(ConservativeConesOracle, CatchesASearchThatStopsTooEarly) {
    const DepthMap map = noiseMap(48, 48, WrapMode::Clamp, 5);
    EXPECT_EQ(countWrongRatios(conesByGrowingSquares(map, false), map, 0), 0u);
    EXPECT_GT(countWrongRatios(conesByGrowingSquares(map, true), map, 0), 0u);
}

TEST(ConservativeConesOracle, CatchesAForgottenWrapModeAndAWrongScale) {
    DepthMap map = textures::generateSampleRelief("wave", 24, 24);
    map.wrap = WrapMode::Clamp;
    Plane ratio = buildConservativeCones(map, ConeGuarantee::Texel);
    EXPECT_EQ(countWrongRatios(ratio, map, 1), 0u);
    map.wrap = WrapMode::Repeat;
    EXPECT_GT(countWrongRatios(ratio, map, 1), 0u);
    map.wrap = WrapMode::Clamp;
    for (float& value : ratio.texels)
        value *= 1.00001f;
    EXPECT_GT(countWrongRatios(ratio, map, 1), 0u);
}

}  // namespace
}  // namespace relievo::preprocess
