// What light gets to a point, against closed forms and against the tracer: what the eye sees is lit
// by a light at the eye.
#include "reference/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reference/surface_crossings.h"
#include "textures/sample_reliefs.h"

namespace relievo::reference {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

DepthMap levelMap(float depth) {
    return {Plane(4, 4, depth), WrapMode::Repeat};
}

// A wall along v with a floor of depth 1 to its right: the surface falls between the centres of the
// texels 7 and 8 of 64. Its edge is at the centre of texel 7.
constexpr int kWallSize = 64;
constexpr double kEdge = 7.5 / kWallSize;

DepthMap wallMap() {
    DepthMap map{Plane(kWallSize, kWallSize, 1.0f), WrapMode::Clamp};
    for (int j = 0; j < kWallSize; ++j)
        for (int i = 0; i < 8; ++i)
            map.depth.at(i, j) = 0.0f;
    return map;
}

TEST(Visibility, OnALevelReliefAllThatComesFromAboveGetsThere) {
    for (const float depth : {0.0f, 0.5f, 1.0f}) {
        const DepthMap map = levelMap(depth);
        EXPECT_TRUE(isLit(map, {0.3, 0.7}, {0.0, 0.0, -1.0}));
        EXPECT_TRUE(isLit(map, {0.3, 0.7}, {1.0, 0.5, -1e-3}));
        EXPECT_FALSE(isLit(map, {0.3, 0.7}, {1.0, 0.0, 0.0}));
        EXPECT_FALSE(isLit(map, {0.3, 0.7}, {1.0, 0.0, 1e-9}));
        EXPECT_FALSE(isLit(map, {0.3, 0.7}, {0.0, 0.0, 1.0}));
        EXPECT_FALSE(isLit(map, {0.3, 0.7}, {0.0, 0.0, 0.0}));
    }
}

TEST(Visibility, TheShadowOfAWallEndsWhereItsEdgeIsSeen) {
    const DepthMap map = wallMap();
    for (const double slope : {2.0, 4.0, 9.0}) {
        const glm::dvec3 light(-1.0, 0.3, -slope);
        const double end = kEdge + 1.0 / slope;
        EXPECT_FALSE(isLit(map, {end - 1e-4, 0.5}, light)) << slope;
        EXPECT_TRUE(isLit(map, {end + 1e-4, 0.5}, light)) << slope;
        EXPECT_TRUE(isLit(map, {kEdge / 2, 0.5}, light)) << "on the wall";
        EXPECT_TRUE(isLit(map, {end - 1e-4, 0.5}, {1.0, 0.3, -slope})) << "from the other side";
    }
}

TEST(Visibility, NothingOutsideTheWindowIsInTheWay) {
    const DepthMap map = wallMap();
    const glm::dvec2 place(0.3, 0.5);
    const glm::dvec3 light(-1.0, 0.0, -2.0);
    EXPECT_FALSE(isLit(map, place, light));
    EXPECT_TRUE(isLit(map, place, light, {{0.2, 0.0}, {1.0, 1.0}}));
    EXPECT_TRUE(isLit(map, place, light, {}, 0.1)) << "nor anything beyond the longest distance";
}

struct RandomPoint {
    glm::dvec2 place;
    glm::dvec3 direction;
};

RandomPoint randomPoint(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double azimuth = 2.0 * std::numbers::pi * unit(random);
    const double rise = std::pow(10.0, 3.0 * unit(random) - 1.0);
    return {{3.0 * unit(random) - 1.0, 3.0 * unit(random) - 1.0},
            {std::cos(azimuth), std::sin(azimuth), -rise}};
}

// A ray to the light that is not `lower` below where the eye's ray hit.
bool isLitFrom(const DepthMap& map, const TileHit& hit, const glm::dvec3& direction, double lower) {
    const TileRay ray{hit.position + glm::dvec3(0.0, 0.0, lower), direction};
    return !getsBelow(map, ray, -ray.origin.z / direction.z);
}

// The self-intersection rule: the light ray leaves its own point, however flat, and no hit of the
// tracer is so far off the surface that this fails. A point that is put a thousandth of the depth
// too low is not lit.
TEST(Visibility, WhatTheEyeSeesIsLitFromTheEye) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
            SCOPED_TRACE(std::string(sample.name));
            DepthMap map = textures::generateSampleRelief(sample.name, 61, 47);
            map.wrap = wrap;
            std::mt19937 random(7);
            int dark = 0;
            int darkWhenLower = 0;
            for (int k = 0; k < 1000; ++k) {
                const RandomPoint point = randomPoint(random);
                const TileRay eye{{point.place, 0.0}, -point.direction};
                const auto hit = traceBilinear(map, eye);
                ASSERT_TRUE(hit);
                dark += !isLit(map, glm::dvec2(hit->position), point.direction);
                darkWhenLower += !isLitFrom(map, *hit, point.direction, 1e-3);
            }
            EXPECT_EQ(dark, 0);
            EXPECT_GT(darkWhenLower, 0);
        }
}

TEST(Visibility, AgreesWithTheDeepestPointOfTheLightRay) {
    const DepthMap map = textures::generateSampleRelief("noise", 32, 32);
    std::mt19937 random(3);
    int lit = 0;
    for (int k = 0; k < 2000; ++k) {
        const RandomPoint point = randomPoint(random);
        const auto floor = traceBilinear(map, {{point.place, 0.0}, {0.0, 0.0, 1.0}});
        ASSERT_TRUE(floor);
        const TileRay ray{floor->position, point.direction};
        const bool isBelow =
            deepestBelow(map, ray, -ray.origin.z / ray.direction.z).depth > kPiercingDepth;
        EXPECT_EQ(isLit(map, point.place, point.direction), !isBelow);
        lit += !isBelow;
    }
    EXPECT_GT(lit, 200);
    EXPECT_LT(lit, 1800);
}

// Before the long straight edge of the wall the share is that of a disc beyond a line.
TEST(Visibility, ShareOfADiscBeforeAWallIsThatOfACircleBeyondALine) {
    const DepthMap map = wallMap();
    const double slope = 4.0;
    const glm::dvec2 place(kEdge + 1.0 / slope, 0.5);  // where the centre is just seen
    const int rays = 4096;
    for (const double line : {-0.9, -0.4, 0.0, 0.3, 0.8}) {
        // Lifted by `line` of the radius the centre is where the edge is.
        const glm::dvec3 lift(0.0, 0.0, -0.5);
        const DiscLight light{glm::dvec3(-1.0, 0.0, -slope) - line * lift, lift, {0.0, 0.1, 0.0}};
        const double share =
            0.5 - (line * std::sqrt(1.0 - line * line) + std::asin(line)) / std::numbers::pi;
        EXPECT_NEAR(visibleShare(map, place, light, rays), share, 2e-3) << line;
        EXPECT_NEAR(visibleShare(map, place, light, 64), share, 0.03) << line;
    }
    EXPECT_EQ(visibleShare(map, place + 1e-3, {{-1.0, 0.0, -slope}}, 64), 1.0);
    EXPECT_EQ(visibleShare(map, place - 1e-3, {{-1.0, 0.0, -slope}}, 64), 0.0);
}

}  // namespace
}  // namespace relievo::reference
