#include "preprocess/distance_volume.h"

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
constexpr double kScale = 0.3;

// How many of `rays` from random points of random voxels, as long as the volume says, get below the
// surface.
int countPiercing(const DepthMap& map, const std::vector<Plane>& volume, double depthScale,
                  double factor, int rays, std::uint32_t seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto slices = static_cast<double>(volume.size());
    int piercing = 0;
    for (int k = 0; k < rays; ++k) {
        const double u = unit(generator);
        const double v = unit(generator);
        const double z = unit(generator);
        const Plane& slice =
            volume[std::min(static_cast<std::size_t>(z * slices), volume.size() - 1)];
        const double radius =
            factor * static_cast<double>(
                         slice.at(std::min(static_cast<int>(u * map.width()), map.width() - 1),
                                  std::min(static_cast<int>(v * map.height()), map.height() - 1)));
        if (!(z < sampleBilinear(map.depth, u, v, map.wrap)) || radius == 0.0)
            continue;
        const double azimuth = 2.0 * std::numbers::pi * unit(generator);
        const double down = 2.0 * unit(generator) - 1.0;
        const double across = std::sqrt(1.0 - down * down);
        const reference::TileRay ray{
            {u, v, z},
            {radius * across * std::cos(azimuth),
             radius * across * std::sin(azimuth) / map.aspect(), radius * down / depthScale}};
        piercing += reference::deepestBelow(map, ray, 1.0).depth > reference::kPiercingDepth;
    }
    return piercing;
}

TEST(DistanceVolume, NoStepPiercesTheBilinearSurface) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 9}, {10, 1}, {2, 2}, {17, 13}, {64, 1}, {31, 24}})
            for (const int slices : {1, 7})
                for (const DepthMap& map :
                     {noiseMap(width, height, wrap, 5), hillMap(width, height, wrap, 0.5)})
                    EXPECT_EQ(countPiercing(map, buildDistanceVolume(map, slices, kScale), kScale,
                                            1.0, 1000, 3),
                              0)
                        << width << "x" << height << " " << wrapModeName(wrap) << " " << slices;
}

TEST(DistanceVolume, StepsThatAreLongerPierceIt) {
    const DepthMap map = hillMap(40, 30, WrapMode::Repeat);
    EXPECT_GT(countPiercing(map, buildDistanceVolume(map, 8, kScale), kScale, 2.0, 5000, 3), 0);
    DepthMap clamped = map;
    clamped.wrap = WrapMode::Clamp;
    clamped.depth.at(0, 15) = 0.0f;
    DepthMap repeated = clamped;
    repeated.wrap = WrapMode::Repeat;
    EXPECT_GT(
        countPiercing(repeated, buildDistanceVolume(clamped, 8, kScale), kScale, 1.0, 50000, 3), 0)
        << "the wrong wrap mode";
}

TEST(DistanceVolume, AtAnotherScaleTheStepShrinksWithIt) {
    const DepthMap map = noiseMap(31, 24, WrapMode::Repeat, 8, 5);
    const std::vector<Plane> volume = buildDistanceVolume(map, 8, kScale);
    for (const double scale : {0.01, 0.15, 2.0})
        EXPECT_EQ(countPiercing(map, volume, scale, std::min(1.0, scale / kScale), 5000, 4), 0);
}

// A point of the surface: texel coordinates and depth.
struct SurfacePoint {
    double x;
    double y;
    double depth;
};

// Points of the surface on a fine lattice over 3×3 tiles.
std::vector<SurfacePoint> pointsOf(const DepthMap& map) {
    constexpr int kPerTexel = 2;
    std::vector<SurfacePoint> points;
    for (int row = -map.height() * kPerTexel; row <= 2 * map.height() * kPerTexel; ++row)
        for (int column = -map.width() * kPerTexel; column <= 2 * map.width() * kPerTexel;
             ++column) {
            const double x = static_cast<double>(column) / kPerTexel;
            const double y = static_cast<double>(row) / kPerTexel;
            points.push_back({x, y,
                              sampleBilinear(map.depth, (x + 0.5) / map.width(),
                                             (y + 0.5) / map.height(), map.wrap)});
        }
    return points;
}

// The least distance from a voxel to any of the points and what is below it, in tile widths.
double sampledDistance(const DepthMap& map, const std::vector<SurfacePoint>& points, int i, int j,
                       double bottom) {
    double least = 1e9;
    for (const SurfacePoint& point : points) {
        const double across = std::max(0.0, std::abs(point.x - i) - 0.5) / map.width();
        const double along =
            std::max(0.0, std::abs(point.y - j) - 0.5) * map.texelAspect / map.width();
        const double down = kScale * std::max(0.0, point.depth - bottom);
        least = std::min(least, across * across + along * along + down * down);
    }
    return std::sqrt(least);
}

TEST(DistanceVolume, IsNearTheTruthAndNeverAboveIt) {
    for (const WrapMode wrap : kWraps) {
        DepthMap map{Plane(24, 16), wrap, 1.3};
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 24; ++i)
                map.depth.at(i, j) = static_cast<float>(0.5 + 0.45 * std::sin(0.2618 * i + 0.2) *
                                                                  std::cos(0.3927 * j));
        const std::vector<Plane> volume = buildDistanceVolume(map, 4, kScale);
        const std::vector<SurfacePoint> points = pointsOf(map);
        double sum = 0.0;
        double truths = 0.0;
        for (int j = 0; j < map.height(); ++j)
            for (int i = 0; i < map.width(); ++i)
                for (int k = 0; k < 4; ++k) {
                    const double truth = sampledDistance(map, points, i, j, (k + 1) / 4.0);
                    const double value = volume[static_cast<std::size_t>(k)].at(i, j);
                    ASSERT_LE(value, truth + 1e-9);
                    // The column begins at the least depth of a square, a texel wide at most.
                    ASSERT_GE(value, truth - 1.5 * std::hypot(1.0, 1.3) / map.width());
                    sum += value;
                    truths += truth;
                }
        // Less than a texel is lost, of distances of some texels in so small a map.
        EXPECT_GT(sum, 0.5 * truths) << wrapModeName(wrap);
    }
}

TEST(DistanceVolume, OfAPlainIsTheDepthBelowTheVoxel) {
    const DepthMap map{Plane(5, 3, 0.75f), WrapMode::Repeat};
    const std::vector<Plane> volume = buildDistanceVolume(map, 4, kScale);
    for (int k = 0; k < 4; ++k)
        for (const float distance : volume[static_cast<std::size_t>(k)].texels)
            EXPECT_NEAR(distance, kScale * std::max(0.0, 0.75 - (k + 1) / 4.0), 1e-6) << k;
}

TEST(DistanceVolume, IsThatOfTheMosaic) {
    const DepthMap map = noiseMap(13, 7, WrapMode::Repeat, 9);
    const DepthMap mosaic = mosaicOf(map, 1);
    const std::vector<Plane> volume = buildDistanceVolume(map, 3, kScale);
    const std::vector<Plane> wide = buildDistanceVolume(mosaic, 3, kScale / 3);
    for (std::size_t k = 0; k < 3; ++k)
        for (int j = 0; j < 7; ++j)
            for (int i = 0; i < 13; ++i)
                EXPECT_NEAR(volume[k].at(i, j), 3.0f * wide[k].at(i + 13, j + 7), 1e-6f);
}

TEST(DistanceVolume, IsTheSameForOneAndTwoThreadsAndTellsOfAllTexels) {
    const DepthMap map = noiseMap(90, 70, WrapMode::Mirror, 5);
    std::size_t texels = 0;
    const auto build = [&] {
        return buildDistanceVolume(map, 3, kScale, [&](std::size_t done) { texels += done; });
    };
    const std::vector<Plane> one = onThreads(1, build);
    EXPECT_EQ(texels, 90u * 70u);
    const std::vector<Plane> two = onThreads(2, build);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(one[k].texels, two[k].texels);
}

}  // namespace
}  // namespace relievo::preprocess
