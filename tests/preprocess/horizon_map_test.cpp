#include "preprocess/horizon_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/preprocess/small_reliefs.h"
#include "tests/preprocess/thread_limit.h"
#include "textures/bilinear.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

// The horizon of the place (x,y), in texels, by small steps along the azimuth for `reach` texels
// along the axis that is nearer to it.
double steppedHorizon(const DepthMap& map, double x, double y, double azimuth, double reach) {
    constexpr int kSteps = 16;
    const double across = std::cos(azimuth);
    const double along = std::sin(azimuth) / map.texelAspect;
    const double perStep = 1.0 / (kSteps * std::max(std::abs(across), std::abs(along)));
    const auto depthAt = [&](double t) {
        return sampleBilinear(map.depth, (x + t * across + 0.5) / map.width(),
                              (y + t * along + 0.5) / map.height(), map.wrap);
    };
    const double depth = depthAt(0.0);
    double slope = 0.0;
    for (int k = 1; k <= reach * kSteps; ++k)
        slope = std::max(slope, (depth - depthAt(k * perStep)) / (k * perStep));
    return slope * map.width();
}

int reachOf(const DepthMap& map, bool alongRows) {
    return (alongRows ? map.width() : map.height()) * (map.wrap == WrapMode::Mirror ? 2 : 1);
}

TEST(HorizonMap, IsExactAlongTheAxes) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 9}, {10, 1}, {2, 2}, {17, 13}, {64, 1}})
            for (const int quarter : {0, 1, 2, 3}) {
                const DepthMap map = noiseMap(width, height, wrap, 5);
                const Plane horizon = buildHorizon(map, azimuthOf(quarter, 4));
                for (int j = 0; j < height; ++j)
                    for (int i = 0; i < width; ++i)
                        EXPECT_NEAR(horizon.at(i, j),
                                    steppedHorizon(map, i, j, azimuthOf(quarter, 4),
                                                   reachOf(map, quarter % 2 == 0)),
                                    1e-5)
                            << width << "x" << height << " " << wrapModeName(wrap) << " "
                            << quarter;
            }
}

struct Comparison {
    int below = 0;  // texels under the stepped horizon
    double sum = 0.0;
    double truths = 0.0;
};

Comparison alongDiagonals(const DepthMap& map, const DepthMap& truth) {
    Comparison comparison;
    for (const int k : {1, 3, 5, 7}) {
        const Plane horizon = buildHorizon(map, azimuthOf(k, 8));
        const int reach = reachOf(map, map.width() >= map.height());
        for (int j = 0; j < map.height(); ++j)
            for (int i = 0; i < map.width(); ++i) {
                const double stepped = steppedHorizon(truth, i, j, azimuthOf(k, 8), reach);
                comparison.below += horizon.at(i, j) < stepped - 1e-5;
                comparison.sum += horizon.at(i, j);
                comparison.truths += stepped;
            }
    }
    return comparison;
}

TEST(HorizonMap, IsNeverBelowTheSurfaceAlongDiagonalsAndNearIt) {
    for (const WrapMode wrap : kWraps) {
        for (const auto& [width, height] : {std::pair{1, 9}, {2, 2}, {17, 13}, {13, 22}}) {
            const DepthMap map = noiseMap(width, height, wrap, 6);
            const Comparison comparison = alongDiagonals(map, map);
            EXPECT_EQ(comparison.below, 0) << wrapModeName(wrap) << " " << width;
            EXPECT_LT(comparison.sum, 1.25 * comparison.truths) << "of noise";
        }
        const DepthMap smooth = hillMap(36, 25, wrap);
        const Comparison comparison = alongDiagonals(smooth, smooth);
        EXPECT_EQ(comparison.below, 0) << wrapModeName(wrap);
        EXPECT_LT(comparison.sum, 1.03 * comparison.truths);
    }
}

TEST(HorizonMap, OfAnotherWrapModeOrReliefIsCaught) {
    const DepthMap map = noiseMap(17, 13, WrapMode::Clamp, 6);
    DepthMap other = map;
    other.wrap = WrapMode::Repeat;
    EXPECT_GT(alongDiagonals(map, other).below, 0);
    other = map;
    other.depth.at(8, 6) = 0.0f;
    EXPECT_GT(alongDiagonals(map, other).below, 0);
}

// Between lines: at least what the surface has at the places on the two lines beside the texel.
TEST(HorizonMap, IsInterpolatedForOtherAzimuths) {
    for (const WrapMode wrap : kWraps)
        for (const double aspect : {1.0, 0.4}) {
            const DepthMap map = hillMap(26, 19, wrap, aspect);
            for (const int k : {1, 4, 7, 12}) {
                const double azimuth = azimuthOf(k, 17);
                const double x = std::cos(azimuth);
                const double y = std::sin(azimuth) / aspect;
                const bool alongRows = std::abs(x) > std::abs(y);
                const double slope = alongRows ? y / x : x / y;
                const Plane horizon = buildHorizon(map, azimuth);
                double error = 0.0;
                double sum = 0.0;
                for (int j = 0; j < map.height(); ++j)
                    for (int i = 0; i < map.width(); ++i) {
                        const double number = alongRows ? j - slope * i : i - slope * j;
                        const double share = number - std::floor(number);
                        const auto beside = [&](double offset) {
                            return steppedHorizon(map, i + (alongRows ? 0.0 : offset),
                                                  j + (alongRows ? offset : 0.0), azimuth,
                                                  reachOf(map, alongRows));
                        };
                        const double expected =
                            (1.0 - share) * beside(-share) + share * beside(1.0 - share);
                        ASSERT_GE(horizon.at(i, j), expected - 1e-5) << k << " " << aspect;
                        error += horizon.at(i, j) - expected;
                        sum += expected;
                    }
                EXPECT_LT(error, 0.03 * sum) << k << " " << aspect << " " << wrapModeName(wrap);
            }
        }
}

TEST(HorizonMap, OfAStepIsItsHeightOverTheDistance) {
    DepthMap map{Plane(32, 16, 1.0f), WrapMode::Clamp};
    for (int j = 0; j < 16; ++j)
        for (int i = 20; i < 32; ++i)
            map.depth.at(i, j) = 0.25f;
    for (const int k : {0, 1, 7}) {
        const Plane horizon = buildHorizon(map, azimuthOf(k, 8));
        for (int i = 6; i < 20; ++i)
            EXPECT_NEAR(horizon.at(i, 8), 0.75 * 32 / (20 - i) * std::cos(azimuthOf(k, 8)), 1e-4);
        EXPECT_EQ(horizon.at(25, 8), 0.0f);
    }
    for (const int k : {2, 3, 4, 5, 6})
        EXPECT_NEAR(buildHorizon(map, azimuthOf(k, 8)).at(10, 8), 0.0f, 1e-6f);
}

TEST(HorizonMap, IsThatOfTheMosaic) {
    const DepthMap map = noiseMap(11, 11, WrapMode::Repeat, 9);
    const DepthMap mosaic = mosaicOf(map, 1);
    for (int k = 0; k < 8; ++k) {
        const Plane horizon = buildHorizon(map, azimuthOf(k, 8));
        const Plane wide = buildHorizon(mosaic, azimuthOf(k, 8));
        for (int j = 0; j < 11; ++j)
            for (int i = 0; i < 11; ++i)
                EXPECT_NEAR(3.0f * horizon.at(i, j), wide.at(i + 11, j + 11), 1e-4f) << k;
    }
}

TEST(HorizonMap, IsTheSameForOneAndTwoThreads) {
    const DepthMap map = noiseMap(90, 70, WrapMode::Mirror, 5);
    const auto build = [&] { return buildHorizon(map, 1.0).texels; };
    EXPECT_EQ(onThreads(1, build), onThreads(2, build));
}

}  // namespace
}  // namespace relievo::preprocess
