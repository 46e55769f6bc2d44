#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "preprocess/relaxed_cones.h"
#include "reference/guarantee_check.h"
#include "tests/preprocess/sampled_cones.h"
#include "tests/preprocess/small_reliefs.h"
#include "textures/sample_reliefs.h"

// Relaxed cones between texel centres against every chord. Those with the guarantee Bilinear:
// bilinear_guarantee_test.cpp.

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

// How many ratios are not those of all chords to the tile and two copies to each side, where these
// must have the steepest. Growth that rounding may change the sign of may count or not.
int countWrong(const DepthMap& map, const Plane& ratio, const SampledSector& sector = {}) {
    const SurfacePoints points{2.5 * map.width(), 2.5 * map.height(), 1.0};
    const double reach = std::min(2.0 * map.width(), 2.0 * map.height() * map.texelAspect);
    const auto least = *std::min_element(map.depth.texels.begin(), map.depth.texels.end());
    int wrong = 0;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i) {
            const double beyond =
                map.wrap == WrapMode::Clamp ? 0.0 : (map.depth.at(i, j) - least) / reach;
            const double strict = steepestChord(map, i, j, points, 1e-6, sector);
            const double loose = std::max(steepestChord(map, i, j, points, -1e-6, sector), beyond);
            const float built = ratio.at(i, j);
            const bool isRight = built <= ratioOfSlope(map, strict) * (1.0 + 1e-9) &&
                                 built >= ratioOfSlope(map, loose) * (1.0 - 3e-6);
            wrong += isRight ? 0 : 1;
        }
    return wrong;
}

TEST(RelaxedCones, BetweenTexelCentresAreThoseOfAllChords) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] :
             {std::pair{1, 1}, {2, 1}, {1, 7}, {3, 3}, {32, 1}, {17, 11}, {13, 19}})
            for (const int levels : {1 << 20, 3}) {
                DepthMap map = noiseMap(width, height, wrap, 3, levels);
                map.texelAspect = width == 13 ? 1.4 : 1.0;
                EXPECT_EQ(countWrong(map, buildRelaxedCones(map, ConeGuarantee::Texel)), 0)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << levels;
            }
}

// Octants are as wide as quadrants where chords to points outside end at the border beside these.
SampledSector builtSector(const DepthMap& map, int number, int sectors) {
    const bool isLine = map.width() == 1 || map.height() == 1;
    if (sectors == 8 && (isLine || map.wrap == WrapMode::Clamp))
        return {number % 4, 4};
    return {number, sectors};
}

TEST(RelaxedCones, OfASectorBetweenTexelCentresAreThoseOfItsChords) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {3, 3}, {17, 11}, {13, 19}})
            for (const int sectors : {4, 8}) {
                DepthMap map = noiseMap(width, height, wrap, 3, width == 17 ? 3 : 1 << 20);
                map.texelAspect = width == 13 ? 1.4 : 1.0;
                const auto ratios = buildRelaxedConeSectors(map, ConeGuarantee::Texel, sectors);
                for (int k = 0; k < sectors; ++k)
                    EXPECT_EQ(countWrong(map, ratios[static_cast<std::size_t>(k)],
                                         builtSector(map, k, sectors)),
                              0)
                        << width << "x" << height << " " << wrapModeName(wrap) << " " << k << " of "
                        << sectors;
            }
}

// Not the near edge of a plateau counts but the far one.
TEST(RelaxedCones, LookAcrossAPlateau) {
    DepthMap map{Plane(40, 1, 1.0f), WrapMode::Clamp};
    for (int i = 10; i <= 20; ++i)
        map.depth.at(i, 0) = 0.25f;
    const Plane ratio = buildRelaxedCones(map, ConeGuarantee::Texel);
    EXPECT_NEAR(ratio.at(4, 0), 16.0 / 0.75 / 40.0, 1e-6);
    EXPECT_NEAR(ratio.at(25, 0), 15.0 / 0.75 / 40.0, 1e-6);
    EXPECT_EQ(ratio.at(15, 0), std::numeric_limits<float>::infinity());
}

// Where the relief is steep from texel to texel, most cones end beside their squares, and what the
// sampling above steps over is found by rays alone.
TEST(RelaxedCones, AreSafeForRaysOnSteepMaps) {
    for (const std::uint32_t seed : {1u, 5u, 13u}) {
        const DepthMap map = textures::generateSampleRelief("noise", 25, 17, seed);
        reference::GuaranteeCheckOptions options;
        options.rays = 200000;
        for (const int sectors : {1, 4, 8}) {
            const auto ratios = buildRelaxedConeSectors(map, ConeGuarantee::Bilinear, sectors);
            EXPECT_EQ(reference::checkCones(map, ratios, reference::ConePromise::Relaxed, options)
                          .violations,
                      0u)
                << seed << " " << sectors;
        }
    }
}

std::uint64_t violations(const DepthMap& map, const std::vector<Plane>& ratios) {
    reference::GuaranteeCheckOptions options;
    options.rays = 100000;
    return reference::checkCones(map, ratios, reference::ConePromise::Relaxed, options).violations;
}

TEST(RelaxedCones, OfSectorsAreSafeInEveryWrapMode) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] : {std::pair{31, 23}, {1, 9}, {16, 1}})
            for (const double aspect : {1.0, 0.7, 1.4})
                for (const int sectors : {4, 8}) {
                    DepthMap map = noiseMap(width, height, wrap, 5);
                    map.texelAspect = aspect;
                    EXPECT_EQ(violations(map, buildRelaxedConeSectors(map, ConeGuarantee::Bilinear,
                                                                      sectors)),
                              0u)
                        << width << "x" << height << " " << wrapModeName(wrap) << " " << aspect
                        << " " << sectors;
                }
}

// The wrong variants: one sector a little wider, and each sector with the cones of the opposite
// one.
TEST(RelaxedCones, OfSectorsAreCaughtWhenTheyAreWiderOrSwapped) {
    for (const int sectors : {4, 8}) {
        const DepthMap map = noiseMap(40, 40, WrapMode::Repeat, 3);
        const auto ratios = buildRelaxedConeSectors(map, ConeGuarantee::Bilinear, sectors);
        ASSERT_EQ(violations(map, ratios), 0u);
        for (std::size_t k = 0; k < ratios.size(); ++k) {
            auto wider = ratios;
            for (float& ratio : wider[k].texels)
                ratio *= 1.5f;
            EXPECT_GT(violations(map, wider), 0u) << k << " of " << sectors;
        }
        auto swapped = ratios;
        for (std::size_t k = 0; k < ratios.size(); ++k)
            swapped[k] = ratios[k ^ 3];
        EXPECT_GT(violations(map, swapped), 0u) << sectors;
    }
}

// A slope that goes on rising hides nothing behind it.
TEST(RelaxedCones, AreUnlimitedOnASlopeWithoutACrest) {
    DepthMap map{Plane(50, 30), WrapMode::Clamp};
    for (int j = 0; j < 30; ++j)
        for (int i = 0; i < 50; ++i)
            map.depth.at(i, j) = static_cast<float>(i) / 64.0f;
    for (const float ratio : buildRelaxedCones(map, ConeGuarantee::Texel).texels)
        EXPECT_EQ(ratio, std::numeric_limits<float>::infinity());
    // The surface has a kink where the map ends: squares on it are bounded.
    const Plane ratio = buildRelaxedCones(map, ConeGuarantee::Bilinear);
    for (int j = 0; j < 30; ++j)
        for (int i = 1; i < 49; ++i)
            EXPECT_EQ(ratio.at(i, j), std::numeric_limits<float>::infinity()) << i << " " << j;
}

TEST(RelaxedCones, OfARepeatedMapAreTheCropOfItsMosaic) {
    const DepthMap map = noiseMap(23, 14, WrapMode::Repeat, 9);
    const DepthMap mosaic = mosaicOf(map, 1);
    for (const ConeGuarantee guarantee : {ConeGuarantee::Texel, ConeGuarantee::Bilinear})
        for (const int sectors : {1, 4, 8}) {
            const auto ratios = buildRelaxedConeSectors(map, guarantee, sectors);
            const auto crops = buildRelaxedConeSectors(mosaic, guarantee, sectors);
            for (std::size_t k = 0; k < ratios.size(); ++k)
                for (int j = 0; j < 14; ++j)
                    for (int i = 0; i < 23; ++i)
                        EXPECT_FLOAT_EQ(ratios[k].at(i, j), 3.0f * crops[k].at(i + 23, j + 14));
        }
}

}  // namespace
}  // namespace relievo::preprocess
