#include "preprocess/cylinder_radii.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "preprocess/tolerant_radii.h"
#include "reference/surface_crossings.h"
#include "tests/preprocess/small_reliefs.h"
#include "tests/preprocess/thread_limit.h"
#include "textures/bilinear.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

// A ray from a random point of the square of texel (i,j), above the surface, that is `radius` tile
// widths long. Most of them aim a little below a point of the surface on their way, so that they
// graze what lies before it.
reference::TileRay drawRay(const DepthMap& map, int i, int j, double radius,
                           std::mt19937& generator) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double u = (i + unit(generator)) / map.width();
    const double v = (j + unit(generator)) / map.height();
    const double depth = sampleBilinear(map.depth, u, v, map.wrap);
    const double z = generator() % 2 == 0 ? depth : depth * unit(generator);
    const double azimuth = generator() % 3 == 0
                               ? std::numbers::pi / 4 * static_cast<double>(generator() % 8)
                               : 2.0 * std::numbers::pi * unit(generator);
    const double du = radius * std::cos(azimuth);
    const double dv = radius * std::sin(azimuth) / map.aspect();
    double down = 0.0;
    if (generator() % 4 != 0) {
        const double t = 0.02 + 0.98 * unit(generator);
        const double aim =
            sampleBilinear(map.depth, u + t * du, v + t * dv, map.wrap) - 0.02 * unit(generator);
        down = std::max(0.0, (aim - z) / t);
    }
    return {{u, v, z}, {du, dv, down}};
}

// How many rays come out of the relief again before they end, at `extra` texels beyond the radius,
// after they were deeper than the tolerance.
int countReappearing(const DepthMap& map, const Plane& radii, double extra, int raysPerTexel,
                     double tolerance = reference::kPiercingDepth) {
    std::mt19937 generator(4);
    int reappearing = 0;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i)
            for (int k = 0; k < raysPerTexel; ++k) {
                const double radius = std::min<double>(radii.at(i, j), 3.0) + extra / map.width();
                if (radius == 0.0)
                    continue;
                reappearing += reference::farthestReappearance(
                                   map, drawRay(map, i, j, radius, generator), 1.0, tolerance)
                                   .depth > reference::kPiercingDepth;
            }
    return reappearing;
}

TEST(CylinderRadii, NoRayPiercesTheReliefTwiceWithin) {
    for (const WrapMode wrap : kWraps) {
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 9}, {10, 1}, {2, 2}, {17, 13}, {64, 1}, {31, 24}})
            for (const DepthMap& map :
                 {noiseMap(width, height, wrap, 5), noiseMap(width, height, wrap, 5, 3),
                  hillMap(width, height, wrap, 0.5)})
                EXPECT_EQ(countReappearing(map, buildCylinderRadii(map), 0.0, 20), 0)
                    << width << "x" << height << " " << wrapModeName(wrap);
        // A few spikes leave wide cylinders.
        DepthMap spikes{Plane(37, 29, 1.0f), wrap, 1.4};
        for (const auto& [i, j] : {std::pair{3, 4}, {20, 11}, {30, 25}, {36, 2}})
            spikes.depth.at(i, j) = 0.1f;
        EXPECT_EQ(countReappearing(spikes, buildCylinderRadii(spikes), 0.0, 40), 0);
    }
}

TEST(CylinderRadii, RaysInWiderOnesDo) {
    DepthMap map = hillMap(31, 24, WrapMode::Repeat);
    EXPECT_GT(countReappearing(map, buildCylinderRadii(map), 2.0, 40), 0);
    DepthMap clamped{Plane(24, 24, 1.0f), WrapMode::Clamp};
    clamped.depth.at(1, 12) = 0.0f;
    DepthMap repeated = clamped;
    repeated.wrap = WrapMode::Repeat;
    EXPECT_GT(countReappearing(repeated, buildCylinderRadii(clamped), 0.0, 40), 0)
        << "the wrong wrap mode";
}

TEST(CylinderRadii, AreUnlimitedWhereNothingStandsOut) {
    for (const WrapMode wrap : kWraps)
        for (const float radius : buildCylinderRadii({Plane(5, 4, 0.3f), wrap}).texels)
            EXPECT_TRUE(std::isinf(radius));
    // At the top of a slope rays come out, on it and on the way up they do not.
    DepthMap slope{Plane(16, 4), WrapMode::Clamp};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 16; ++i)
            slope.depth.at(i, j) = static_cast<float>(i) / 16.0f;
    const Plane radii = buildCylinderRadii(slope);
    for (int i = 0; i < 16; ++i)
        EXPECT_EQ(std::isinf(radii.at(i, 1)), i > 1) << i;
    EXPECT_EQ(radii.at(0, 1), 0.0f);
}

// Rays from the flank come out behind the crest; their squares are half a texel nearer to it.
TEST(CylinderRadii, EndAtTheCrestsOfRidges) {
    DepthMap map{Plane(32, 8), WrapMode::Repeat};
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 32; ++i)
            map.depth.at(i, j) = static_cast<float>(std::abs(i - 16)) / 16.0f;
    const Plane radii = buildCylinderRadii(map);
    for (int i = 0; i < 32; ++i)
        EXPECT_NEAR(radii.at(i, 3), std::abs(i - 16) < 2 ? 0.0 : (std::abs(i - 16) - 0.5) / 32.0,
                    1e-6)
            << i;
}

TEST(CylinderRadii, AroundASpikeAreTheDistanceToItsCells) {
    for (const double aspect : {1.0, 0.5}) {
        DepthMap map{Plane(33, 33, 1.0f), WrapMode::Clamp, aspect};
        map.depth.at(16, 16) = 0.0f;
        const Plane radii = buildCylinderRadii(map);
        const auto radiusFrom = [&](int i, int j) {
            return std::hypot(std::max(0.0, std::abs(i - 16) - 0.5),
                              aspect * std::max(0.0, std::abs(j - 16) - 0.5)) /
                   33.0;
        };
        for (int j = 0; j < 33; ++j)
            for (int i = 0; i < 33; ++i) {
                EXPECT_LE(radii.at(i, j), radiusFrom(i, j) + 1e-6);
                EXPECT_GE(radii.at(i, j), radiusFrom(i, j) - 1.5 / 33.0) << i << " " << j;
            }
    }
}

TEST(CylinderRadii, AreThoseOfTheMosaic) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror}) {
        DepthMap map{Plane(13, 8, 1.0f), wrap};
        for (const auto& [i, j] : {std::pair{2, 3}, {9, 7}})
            map.depth.at(i, j) = 0.2f;
        DepthMap mosaic = mosaicOf(map, 1);
        mosaic.wrap = WrapMode::Clamp;
        const Plane radii = buildCylinderRadii(map);
        const Plane wide = buildCylinderRadii(mosaic);
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 13; ++i)
                EXPECT_NEAR(radii.at(i, j), 3.0f * wide.at(i + 13, j + 8), 1e-6f)
                    << wrapModeName(wrap);
    }
}

TEST(CylinderRadii, AreTheSameForOneAndTwoThreads) {
    const DepthMap map = noiseMap(150, 70, WrapMode::Mirror, 5, 3);
    const auto build = [&] { return buildCylinderRadii(map).texels; };
    EXPECT_EQ(onThreads(1, build), onThreads(2, build));
}

TEST(TolerantRadii, NoRayComesOutAfterItWasDeeperThanTheTolerance) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 9}, {10, 1}, {17, 13}, {64, 1}, {31, 24}})
            for (const double tolerance : {0.01, 0.1, 0.5})
                for (const DepthMap& map :
                     {noiseMap(width, height, wrap, 5), noiseMap(width, height, wrap, 5, 3),
                      hillMap(width, height, wrap, 0.5), hillMap(width, height, wrap, 1.7)})
                    EXPECT_EQ(countReappearing(map, buildTolerantRadii(map, tolerance), 0.0, 20,
                                               tolerance),
                              0)
                        << width << "x" << height << " " << wrapModeName(wrap) << " " << tolerance;
}

TEST(TolerantRadii, RaysInWiderOnesDo) {
    const DepthMap map = hillMap(31, 24, WrapMode::Repeat);
    constexpr double kTolerance = 0.03;
    Plane radii = buildTolerantRadii(map, kTolerance);
    for (float& radius : radii.texels)
        radius *= 3.0f;
    EXPECT_GT(countReappearing(map, radii, 0.0, 40, kTolerance), 0);
    DepthMap ridge{Plane(24, 6), WrapMode::Clamp};
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 24; ++i)
            ridge.depth.at(i, j) = static_cast<float>(i) / 24.0f;
    DepthMap repeated = ridge;
    repeated.wrap = WrapMode::Repeat;
    EXPECT_GT(
        countReappearing(repeated, buildTolerantRadii(ridge, kTolerance), 0.0, 40, kTolerance), 0)
        << "the wrong wrap mode";
}

// Slopes of 1/16 of the depth per texel on both sides of the crest of a ridge: two gradients differ
// by 1/8, so that a tolerance of 0.05 goes as far as 4·0.05·8 = 1.6 texels.
TEST(TolerantRadii, OverARidgeAreGivenByItsSlopes) {
    DepthMap map{Plane(32, 8), WrapMode::Repeat};
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 32; ++i)
            map.depth.at(i, j) = static_cast<float>(std::abs(i - 16)) / 16.0f;
    const Plane radii = buildTolerantRadii(map, 0.05);
    EXPECT_NEAR(32.0 * radii.at(16, 3), 1.6, 1e-5);
    EXPECT_NEAR(32.0 * radii.at(8, 3), 5.5, 1e-5) << "windows of 6 texels see a plane";
    for (const float radius : buildTolerantRadii({Plane(5, 4, 0.3f), WrapMode::Clamp}, 0.05).texels)
        EXPECT_TRUE(std::isinf(radius));
}

TEST(TolerantRadii, AreWideOnSmoothHillsWhereTheOthersAreNone) {
    const DepthMap map = hillMap(64, 64, WrapMode::Repeat);
    const Plane strict = buildCylinderRadii(map);
    const Plane tolerant = buildTolerantRadii(map, 0.05);
    EXPECT_EQ(std::count(strict.texels.begin(), strict.texels.end(), 0.0f), 64 * 64);
    EXPECT_GT(*std::min_element(tolerant.texels.begin(), tolerant.texels.end()), 0.0f);
}

TEST(TolerantRadii, AreThoseOfTheMosaicForAnyNumberOfThreads) {
    for (const WrapMode wrap : kWraps) {
        const DepthMap map = hillMap(13, 8, wrap, 1.2);
        const auto build = [&] { return buildTolerantRadii(map, 0.1).texels; };
        EXPECT_EQ(onThreads(1, build), onThreads(2, build));
        const Plane radii = buildTolerantRadii(map, 0.1);
        const Plane wide = buildTolerantRadii(mosaicOf(map, 1), 0.1);
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 13; ++i)
                EXPECT_NEAR(radii.at(i, j), 3.0f * wide.at(i + 13, j + 8), 1e-6f);
    }
}

}  // namespace
}  // namespace relievo::preprocess
