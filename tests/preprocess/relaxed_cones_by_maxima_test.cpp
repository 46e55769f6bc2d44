#include "preprocess/relaxed_cones_by_maxima.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// The same map with everything that is not a maximum sunk to the bottom, except one texel: the
// widest cone on that texel that holds nothing of the rest is the one asked for.
double ratioByBruteForce(const DepthMap& map, int i, int j) {
    const std::vector<std::uint8_t> maxima = markLocalMaxima(map);
    DepthMap peaks = map;
    for (std::size_t k = 0; k < maxima.size(); ++k)
        if (maxima[k] == 0)
            peaks.depth.texels[k] = 2.0f;
    peaks.depth.at(i, j) = map.depth.at(i, j);
    return bruteForceRatio(peaks, i, j, 1);
}

std::size_t countWrong(const Plane& ratio, const DepthMap& map) {
    std::size_t wrong = 0;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i)
            wrong += isTrueRatio(ratio.at(i, j), ratioByBruteForce(map, i, j)) ? 0 : 1;
    return wrong;
}

// A crest along u = ½ that sinks from v = 0 to v = 1.
DepthMap slopingRidge(int size) {
    DepthMap map{Plane(size, size), WrapMode::Clamp};
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i)
            map.depth.at(i, j) = static_cast<float>(
                std::min(1.0, 0.1 + 0.4 * j / size + 4.0 * std::abs(i - size / 2) / size));
    return map;
}

TEST(RelaxedConesByMaxima, EqualBruteForceOverTheMaximaWithALevelForEachDepth) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair{1, 1}, {1, 13}, {23, 17}, {24, 2}}) {
            const DepthMap map = noiseMap(width, height, wrap, 3, 12);
            EXPECT_EQ(countWrong(buildRelaxedConesByMaxima(map), map), 0u)
                << width << "x" << height << " " << wrapModeName(wrap);
        }
}

TEST(RelaxedConesByMaxima, AreCaughtWhenTheyForgetToRepeat) {
    DepthMap map = noiseMap(23, 17, WrapMode::Clamp, 3, 12);
    const Plane ratio = buildRelaxedConesByMaxima(map);
    map.wrap = WrapMode::Repeat;
    EXPECT_GT(countWrong(ratio, map), 0u);
}

TEST(RelaxedConesByMaxima, MaximaAreMarkedAcrossBordersAndOnFlatTops) {
    DepthMap map{Plane(4, 1), WrapMode::Repeat};
    map.depth.texels = {0.2f, 0.5f, 0.5f, 0.1f};
    EXPECT_EQ(markLocalMaxima(map), (std::vector<std::uint8_t>{0, 0, 0, 1}));
    map.wrap = WrapMode::Clamp;
    EXPECT_EQ(markLocalMaxima(map), (std::vector<std::uint8_t>{1, 0, 0, 1}));
    map.depth.texels = {0.5f, 0.1f, 0.1f, 0.5f};
    EXPECT_EQ(markLocalMaxima(map), (std::vector<std::uint8_t>{0, 1, 1, 0}));
    map.depth.texels.assign(4, 0.3f);
    EXPECT_EQ(markLocalMaxima(map), (std::vector<std::uint8_t>(4, 1)));
}

TEST(RelaxedConesByMaxima, AreNeverNarrowerThanConservativeOnes) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        const DepthMap map = textures::generateSampleRelief(sample.name, 48, 40);
        const Plane conservative = buildConesBySquares(map);
        const Plane relaxed = buildRelaxedConesByMaxima(map, 1 << 20);
        for (std::size_t k = 0; k < relaxed.texels.size(); ++k)
            ASSERT_GE(relaxed.texels[k], conservative.texels[k] * (1.0f - 1e-6f)) << sample.name;
    }
}

// Why they are a baseline only. A level ray straight across the ridge, as deep as its crest in this
// row, enters the relief there and is out again a texel further on: no cone may reach so far.
TEST(RelaxedConesByMaxima, ReachAcrossACrestThatSlopes) {
    const int size = 48;
    const DepthMap map = slopingRidge(size);
    const auto countReachingAcross = [&](const Plane& ratio) {
        std::size_t count = 0;
        for (int j = 8; j < size; ++j)
            for (int i = 0; i < size / 2; ++i) {
                const double drop = map.depth.at(i, j) - map.depth.at(size / 2, j);
                count += ratio.at(i, j) * drop > (size / 2 - i + 1.0) / size ? 1 : 0;
            }
        return count;
    };
    EXPECT_GT(countReachingAcross(buildRelaxedConesByMaxima(map)), 500u);
    EXPECT_EQ(countReachingAcross(buildConesBySquares(map)), 0u);
}

}  // namespace
}  // namespace relievo::preprocess
