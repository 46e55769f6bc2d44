// Closed forms, borders of cells and window, and rays that are degenerate in every way.
#include "reference/bilinear_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "ray_oracle.h"
#include "textures/bilinear.h"

namespace relievo::reference::test {
namespace {

using textures::DepthMap;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

DepthMap makeMap(int width, int height, WrapMode wrap,
                 const std::function<double(int, int)>& depth) {
    DepthMap map{textures::Plane(width, height), wrap};
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            map.depth.at(i, j) = static_cast<float>(depth(i, j));
    return map;
}

DepthMap flatMap(int width, int height, WrapMode wrap, double depth) {
    return makeMap(width, height, wrap, [=](int, int) { return depth; });
}

TEST(BilinearTracer, Plane) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {7, 1}, {5, 3}}) {
            const DepthMap map = flatMap(width, height, wrap, 0.25);
            for (const double slope : {1e6, 10.0, 1.0, 0.1, 1e-2}) {
                const TileRay ray{{0.3, -0.7, 0.0}, {0.6, 0.8, slope}};
                const auto hit = traceBilinear(map, ray);
                ASSERT_TRUE(hit);
                EXPECT_NEAR(hit->t * slope, 0.25, 1e-14);
                EXPECT_NEAR(hit->position.z, 0.25, 1e-14);
                EXPECT_FALSE(hit->startsInside);
            }
        }
}

TEST(BilinearTracer, FloorIsHitAtEveryAngle) {
    const DepthMap map = flatMap(3, 5, WrapMode::Repeat, 1.0);
    for (int k = 0; k < 2000; ++k) {
        const double azimuth = 0.01 * k;
        const TileRay ray{{0.001 * k, 0.3, -0.1},
                          {std::cos(azimuth), std::sin(azimuth), 0.02 + 0.003 * k}};
        const auto hit = traceBilinear(map, ray);
        ASSERT_TRUE(hit) << k;
        EXPECT_NEAR(hit->position.z, 1.0, 1e-14);
        EXPECT_FALSE(hit->startsInside);
    }
}

TEST(BilinearTracer, TopPlateausAreHitAndNotFromInside) {
    const DepthMap map = flatMap(3, 5, WrapMode::Repeat, 0.0);
    for (int k = 1; k < 2000; ++k) {
        const TileRay ray{{0.3, 0.7, -0.0013 * k}, {1.0, 0.37, 0.1 + 0.0007 * k}};
        const auto hit = traceBilinear(map, ray);
        ASSERT_TRUE(hit) << k;
        EXPECT_EQ(hit->position.z, 0.0);
        EXPECT_FALSE(hit->startsInside);
    }
}

TEST(BilinearTracer, Ramp) {
    // D = x/8 between the centres of 9 texels; ray z = z0 + t·vz, x = 9·(u0 + t·vx) − ½.
    const DepthMap map = makeMap(9, 4, WrapMode::Clamp, [](int i, int) { return i / 8.0; });
    for (const double vz : {-1.5, -0.2, 0.0, 0.3, 2.0})
        for (const double vx : {-1.0, -0.3, 0.0}) {
            const TileRay ray{{0.8, 0.4, 0.1}, {vx, 0.25, vz}};
            const double start = (9.0 * 0.8 - 0.5) / 8.0;
            const double closing = vz - 9.0 * vx / 8.0;
            const double t = (start - 0.1) / closing;
            const auto hit = traceBilinear(map, ray);
            const double z = 0.1 + t * vz;
            if (closing > 0.0 && z >= 0.0 && z <= 1.0) {
                ASSERT_TRUE(hit) << vx << ' ' << vz;
                EXPECT_NEAR(hit->t, t, 1e-14);
            } else {
                EXPECT_FALSE(hit) << vx << ' ' << vz;
            }
        }
}

TEST(BilinearTracer, SaddleAlongItsDiagonal) {
    // D = 1 − x·y in the middle cell; the level ray x = y at depth ¾ meets it at x² = ¼.
    const DepthMap map =
        makeMap(2, 2, WrapMode::Clamp, [](int i, int j) { return i * j == 1 ? 0.0 : 1.0; });
    const auto hit = traceBilinear(map, {{0.25, 0.25, 0.75}, {0.5, 0.5, 0.0}});
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->t, 0.5);
    // Across, x + y = 1: D = 1 − x(1−x) is ¾ at its least. A hair above it the ray passes, a hair
    // below it is stopped, inside the cell and nowhere near its border.
    const glm::dvec3 start(0.25, 0.75, 0.75);
    const glm::dvec3 across(0.5, -0.5, 0.0);
    EXPECT_FALSE(traceBilinear(map, {start - glm::dvec3(0, 0, 1e-12), across}));
    const auto grazing = traceBilinear(map, {start + glm::dvec3(0, 0, 1e-12), across});
    ASSERT_TRUE(grazing);
    EXPECT_NEAR(grazing->t, 0.5, 1e-5);
}

TEST(BilinearTracer, WaveByDenseSearchAndByItsFormula) {
    const auto wave = [](double u) { return 0.5 + 0.4 * std::cos(2.0 * std::numbers::pi * u); };
    const DepthMap map =
        makeMap(256, 2, WrapMode::Repeat, [&](int i, int) { return wave((i + 0.5) / 256.0); });
    // A chord deviates from the wave by at most h²/8 · max|D''|; floats add 3e-8.
    const double interpolationError = 0.4 * 4.0 * 9.87 / (8.0 * 256.0 * 256.0) + 6e-8;
    for (const double slope : {5.0, 1.0, 0.3, 0.1}) {
        const TileRay ray{{0.37, 0.2, 0.0}, {1.0, 0.0, slope}};
        const auto hit = traceBilinear(map, ray);
        const auto marched = marchToHit(map, ray, {}, 1e3, 64.0);
        ASSERT_TRUE(hit && marched);
        EXPECT_NEAR(hit->t, *marched, 1e-12);
        EXPECT_NEAR(hit->position.z, wave(hit->position.x), interpolationError);
    }
}

TEST(BilinearTracer, RaysOnBordersOfCellsAndThroughTexelCentres) {
    // Pits everywhere but at texel (3,3), whose spike every ray below must meet exactly.
    for (const WrapMode wrap : kWraps) {
        const DepthMap map =
            makeMap(8, 8, wrap, [](int i, int j) { return i == 3 && j == 3 ? 0.0 : 1.0; });
        const glm::dvec3 spike(3.5 / 8.0, 3.5 / 8.0, 0.0);
        for (const glm::dvec2 step : {glm::dvec2(1, 0),
                                      {0, 1},
                                      {-1, 0},
                                      {0, -1},
                                      {1, 1},
                                      {-1, 1},
                                      {1, -1},
                                      {-1, -1},
                                      {2, 1},
                                      {-1, 2}}) {
            // Towards the spike from two texels off, down to its tip at z = 0 from above.
            const glm::dvec3 direction(step / 8.0, 0.5);
            const auto tip = traceBilinear(map, {spike - 2.0 * direction, direction});
            ASSERT_TRUE(tip) << step.x << ' ' << step.y;
            EXPECT_DOUBLE_EQ(tip->t, 2.0);
            EXPECT_FALSE(tip->startsInside);
            // Level at depth ½ along the axes: half a texel before the centre.
            if (step.x * step.y == 0.0) {
                const glm::dvec3 level(step / 8.0, 0.0);
                const glm::dvec3 start = spike + glm::dvec3(0, 0, 0.5) - 2.0 * level;
                const auto flank = traceBilinear(map, {start, level});
                ASSERT_TRUE(flank);
                EXPECT_DOUBLE_EQ(flank->t, 1.5);
            }
        }
    }
}

TEST(BilinearTracer, VerticalRaysReturnTheDepth) {
    const DepthMap map = makeMap(5, 4, WrapMode::Mirror,
                                 [](int i, int j) { return 0.05 * i + 0.1 * j + 0.03 * i * j; });
    for (double u = -1.5; u < 2.5; u += 0.0625)
        for (double v = -1.5; v < 2.5; v += 0.0625) {
            const auto hit = traceBilinear(map, {{u, v, -1.0}, {0.0, 0.0, 0.5}});
            ASSERT_TRUE(hit);
            EXPECT_NEAR(hit->position.z, textures::sampleBilinear(map.depth, u, v, map.wrap),
                        1e-15);
        }
}

TEST(BilinearTracer, OriginInsideTheSolid) {
    const DepthMap map = flatMap(4, 4, WrapMode::Repeat, 0.5);
    const auto inside = traceBilinear(map, {{0.1, 0.1, 0.75}, {1.0, 0.0, -0.1}});
    ASSERT_TRUE(inside);
    EXPECT_TRUE(inside->startsInside);
    EXPECT_EQ(inside->t, 0.0);
    const auto onIt = traceBilinear(map, {{0.1, 0.1, 0.5}, {1.0, 0.0, -0.1}});
    ASSERT_TRUE(onIt);
    EXPECT_FALSE(onIt->startsInside);
    const auto still = traceBilinear(map, {{0.1, 0.1, 0.75}, {0.0, 0.0, 0.0}});
    ASSERT_TRUE(still);
    EXPECT_TRUE(still->startsInside);
    EXPECT_FALSE(traceBilinear(map, {{0.1, 0.1, 0.25}, {0.0, 0.0, 0.0}}));
    // From under the floor a rising ray comes in through the solid.
    const auto below = traceBilinear(map, {{0.1, 0.1, 2.0}, {0.0, 0.0, -0.5}});
    ASSERT_TRUE(below);
    EXPECT_TRUE(below->startsInside);
    EXPECT_EQ(below->t, 2.0);
}

TEST(BilinearTracer, WindowSides) {
    const DepthMap map = flatMap(4, 4, WrapMode::Repeat, 0.5);
    const TileWindow window{{0.0, 0.0}, {1.0, 1.0}};
    // Through the side, above the surface, then down to it.
    const auto above = traceBilinear(map, {{-1.0, 0.5, 0.0}, {1.0, 0.0, 0.3}}, window);
    ASSERT_TRUE(above);
    EXPECT_FALSE(above->startsInside);
    EXPECT_NEAR(above->position.x, 2.0 / 3.0, 1e-12);
    // Through the side, below the surface.
    const auto below = traceBilinear(map, {{2.0, 0.5, 0.3}, {-1.0, 0.0, 0.3}}, window);
    ASSERT_TRUE(below);
    EXPECT_TRUE(below->startsInside);
    EXPECT_EQ(below->position.x, 1.0);
    EXPECT_EQ(below->t, 1.0);
    // Out through the far side before it reaches the surface.
    EXPECT_FALSE(traceBilinear(map, {{-1.0, 0.5, 0.0}, {1.0, 0.0, 0.2}}, window));
    // Past the corner, away from it, and along the outside.
    EXPECT_FALSE(traceBilinear(map, {{-1.0, 0.5, 0.6}, {1.0, -1.0, 0.0}}, window));
    EXPECT_FALSE(traceBilinear(map, {{-1.0, 0.5, 0.6}, {-1.0, 0.0, 0.0}}, window));
    EXPECT_FALSE(traceBilinear(map, {{-1.0, 0.5, 0.6}, {0.0, 1.0, 0.0}}, window));
    // On the border itself a ray is in the window.
    EXPECT_TRUE(traceBilinear(map, {{0.0, 0.5, 0.0}, {0.0, 0.0, 1.0}}, window));
    // Up and away, and down from above.
    EXPECT_FALSE(traceBilinear(map, {{0.5, 0.5, -1.0}, {0.1, 0.0, -1.0}}, window));
    EXPECT_TRUE(traceBilinear(map, {{0.5, 0.5, -1.0}, {0.1, 0.0, 1.0}}, window));
    EXPECT_FALSE(traceBilinear(map, {{0.5, 0.5, -1.0}, {0.1, 0.0, 0.0}}, window));
    // One side bounded only.
    const TileWindow half{{0.5, -std::numeric_limits<double>::infinity()},
                          {std::numeric_limits<double>::infinity(), 0.6}};
    EXPECT_TRUE(traceBilinear(map, {{0.4, 0.5, 0.0}, {1.0, 0.0, 1.0}}, half));
    EXPECT_FALSE(traceBilinear(map, {{0.4, 0.5, 0.0}, {0.0, 0.0, 1.0}}, half));
}

TEST(BilinearTracer, RaysWithoutEndAreGivenUp) {
    for (const WrapMode wrap : kWraps) {
        const DepthMap map = makeMap(8, 8, wrap, [](int i, int) { return 0.5 + 0.05 * i; });
        EXPECT_FALSE(traceBilinear(map, {{0.5, 0.5, 0.25}, {1.0, 0.7, 0.0}}));
        // Nearly level: the surface is 250,000 tiles away.
        const TileRay flat{{0.5, 0.5, 0.25}, {1.0, 0.0, 1e-6}};
        EXPECT_FALSE(traceBilinear(map, flat));
        EXPECT_TRUE(traceBilinear(map, flat, {}, 1e6));
    }
}

TEST(BilinearTracer, ClampedMapIsConstantOutsideItsTile) {
    const DepthMap map =
        makeMap(4, 4, WrapMode::Clamp, [](int i, int j) { return 0.1 * i + 0.2 * j; });
    // Far beyond the left and top sides: the depth of texel (0,0). A walk over every texel on the
    // way, 4·10⁸ of them, would not come to an end here.
    const auto far = traceBilinear(map, {{-1e8, -1e8, 0.0}, {-1.0, -1.0, 1e-9}}, {}, 1e9);
    ASSERT_TRUE(far);
    EXPECT_EQ(far->t, 0.0);
    const auto deep = traceBilinear(map, {{1e8, 1e8, 0.0}, {1.0, 1.0, 1e-8}}, {}, 1e9);
    ASSERT_TRUE(deep);
    EXPECT_NEAR(deep->t, static_cast<double>(map.at(3, 3)) * 1e8, 1e-6);
    // Beyond the left side only, the rows still differ.
    const auto side = traceBilinear(map, {{-1e6, 0.0, 0.25}, {0.0, -1.0, 0.0}});
    EXPECT_TRUE(side && side->startsInside);
    const auto wall = traceBilinear(map, {{-1e6, 1.0, 0.25}, {0.0, -1.0, 0.0}});
    ASSERT_TRUE(wall);
    EXPECT_NEAR(4.0 * wall->position.y - 0.5, 1.25, 1e-6);
}

TEST(BilinearTracer, LengthOfTheDirectionOnlyScalesT) {
    const DepthMap map =
        makeMap(8, 8, WrapMode::Repeat, [](int i, int j) { return ((i * 5 + j * 3) % 8) / 8.0; });
    const TileRay ray{{0.123, 0.456, -0.1}, {0.31, -0.17, 0.11}};
    const auto unit = traceBilinear(map, ray);
    ASSERT_TRUE(unit);
    for (const int exponent : {-900, -60, 3, 60, 900}) {
        const double scale = std::ldexp(1.0, exponent);
        const auto scaled = traceBilinear(map, {ray.origin, ray.direction * scale});
        ASSERT_TRUE(scaled) << exponent;
        EXPECT_EQ(scaled->t * scale, unit->t) << exponent;
        EXPECT_EQ(scaled->position, unit->position) << exponent;
    }
}

TEST(BilinearTracer, RaysThatAreNotNumbersHitNothing) {
    const DepthMap map = flatMap(4, 4, WrapMode::Repeat, 0.5);
    for (const double bad :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        for (int axis = 0; axis < 3; ++axis) {
            TileRay ray{{0.5, 0.5, 0.0}, {0.1, 0.1, 1.0}};
            ASSERT_TRUE(traceBilinear(map, ray));
            ray.origin[axis] = bad;
            EXPECT_FALSE(traceBilinear(map, ray));
            ray = {{0.5, 0.5, 0.0}, {0.1, 0.1, 1.0}};
            ray.direction[axis] = bad;
            EXPECT_FALSE(traceBilinear(map, ray));
        }
    EXPECT_FALSE(traceBilinear(map, {{1e300, 0.5, 0.0}, {0.1, 0.1, 1.0}}));
    // A far origin is no obstacle when the ray comes into the window.
    EXPECT_TRUE(traceBilinear(map, {{-1e12, 0.5, 0.25}, {1.0, 0.0, 2.5e-13}}, {{0, 0}, {1, 1}}));
}

TEST(BilinearNormal, FollowsSlopeAndDepthScale) {
    // D = 0.1·i + 0.05·j: slopes 0.1·8 and 0.05·8 per tile width, whatever the height.
    const DepthMap map =
        makeMap(8, 4, WrapMode::Clamp, [](int i, int j) { return 0.1 * i + 0.05 * j; });
    for (const double scale : {0.0, 1e-6, 0.1, 1.0, 1e3}) {
        const glm::dvec3 normal = bilinearNormal(map, 0.4, 0.6, scale);
        const glm::dvec3 expected = glm::normalize(glm::dvec3(0.8 * scale, 0.4 * scale, 1.0));
        EXPECT_LT(glm::length(normal - expected), 1e-6);
    }
    EXPECT_EQ(bilinearNormal(map, 0.4, 0.6, 0.0), glm::dvec3(0, 0, 1));
    // Flat beyond the clamped corner.
    EXPECT_EQ(bilinearNormal(map, -3.0, -3.0, 1.0), glm::dvec3(0, 0, 1));
}

TEST(BilinearNormal, IsTheGradientOfTheSurface) {
    const DepthMap map =
        makeMap(7, 5, WrapMode::Mirror, [](int i, int j) { return ((i * 5 + j * 3) % 8) / 8.0; });
    const double scale = 0.2;
    const double h = 1e-6;
    for (double u = -0.913; u < 2.0; u += 0.117)
        for (double v = -0.871; v < 2.0; v += 0.131) {
            const auto depth = [&](double du, double dv) {
                return textures::sampleBilinear(map.depth, u + du, v + dv, map.wrap);
            };
            const double slopeU = (depth(h, 0) - depth(-h, 0)) / (2 * h);
            const double slopeV = (depth(0, h) - depth(0, -h)) / (2 * h) / map.aspect();
            const glm::dvec3 expected =
                glm::normalize(glm::dvec3(scale * slopeU, scale * slopeV, 1.0));
            EXPECT_LT(glm::length(bilinearNormal(map, u, v, scale) - expected), 1e-8);
        }
}

}  // namespace
}  // namespace relievo::reference::test
