#include "preprocess/cylinder_radii.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

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

// How many rays come out of the relief again before they end, at `extra` texels beyond the radius.
int countReappearing(const DepthMap& map, const Plane& radii, double extra, int raysPerTexel) {
    std::mt19937 generator(4);
    int reappearing = 0;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i)
            for (int k = 0; k < raysPerTexel; ++k) {
                const double radius = std::min<double>(radii.at(i, j), 3.0) + extra / map.width();
                if (radius == 0.0)
                    continue;
                reappearing +=
                    reference::farthestReappearance(map, drawRay(map, i, j, radius, generator), 1.0)
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

}  // namespace
}  // namespace relievo::preprocess
