// Random rays over random maps: every hit is checked against the surface itself, and against
// marching; the same check must find fault with tracers that are wrong on purpose.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "ray_oracle.h"

namespace relievo::reference::test {
namespace {

using textures::DepthMap;
using textures::WrapMode;

constexpr double kMaxDistance = 3.0;

struct Size {
    int width;
    int height;
};

enum class Origin { Above, Shell };
enum class Course { Descending, Rising, Level, AxisParallel, Vertical };

DepthMap randomMap(Size size, WrapMode wrap, std::mt19937& random, bool binary) {
    DepthMap map{textures::Plane(size.width, size.height), wrap};
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    for (float& depth : map.depth.texels)
        depth = binary ? std::round(value(random)) : value(random);
    return map;
}

TileRay randomRay(const DepthMap& map, Origin origin, Course course, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    TileRay ray;
    ray.origin = {4.0 * unit(random) - 1.5, 4.0 * unit(random) - 1.5,
                  origin == Origin::Above ? -0.25 * unit(random) : unit(random)};
    const double azimuth = course == Course::AxisParallel
                               ? std::floor(4.0 * unit(random)) * 0.5 * std::numbers::pi
                               : 2.0 * std::numbers::pi * unit(random);
    // Depth per tile width, from steep to grazing.
    const double slope = std::pow(10.0, 3.0 * unit(random) - 1.5);
    ray.direction = {std::cos(azimuth), std::sin(azimuth) / map.aspect(), slope};
    if (course == Course::AxisParallel)
        (std::abs(ray.direction.x) < 0.5 ? ray.direction.x : ray.direction.y) = 0.0;
    if (course == Course::Rising)
        ray.direction.z = -slope;
    if (course == Course::Level)
        ray.direction.z = 0.0;
    if (course == Course::Vertical)
        ray.direction = {0.0, 0.0, unit(random) < 0.5 ? 1.0 : -1.0};
    return ray;
}

TileWindow randomWindow(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    if (unit(random) < 0.5)
        return {};
    const glm::dvec2 low(2.0 * unit(random) - 1.0, 2.0 * unit(random) - 1.0);
    return {low, low + glm::dvec2(0.2 + unit(random), 0.2 + unit(random))};
}

/// Calls `check` with `rays` rays of every origin and course on maps of every size and wrap mode.
void forRandomRays(
    int rays,
    const std::function<void(const DepthMap&, const TileRay&, const TileWindow&)>& check) {
    std::mt19937 random(20240611);
    for (const Size size : {Size{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 5}, {17, 13}, {40, 8}})
        for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
            for (const bool binary : {false, true}) {
                const DepthMap map = randomMap(size, wrap, random, binary);
                for (const Origin origin : {Origin::Above, Origin::Shell})
                    for (const Course course : {Course::Descending, Course::Rising, Course::Level,
                                                Course::AxisParallel, Course::Vertical})
                        for (int k = 0; k < rays; ++k) {
                            const TileRay ray = randomRay(map, origin, course, random);
                            check(map, ray, randomWindow(random));
                        }
            }
}

std::string describe(const DepthMap& map, const TileRay& ray) {
    return fmt::format("{}x{} {}, origin ({}, {}, {}), direction ({}, {}, {})", map.width(),
                       map.height(), textures::wrapModeName(map.wrap), ray.origin.x, ray.origin.y,
                       ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z);
}

std::size_t violationsOf(const Tracer& tracer) {
    std::size_t violations = 0;
    forRandomRays(60, [&](const DepthMap& map, const TileRay& ray, const TileWindow& window) {
        const auto hit = tracer(map, ray, window);
        violations += violation(map, ray, window, hit, kMaxDistance) ? 1 : 0;
    });
    return violations;
}

TEST(RandomRays, HitIsOnTheSurfaceAndNothingIsBefore) {
    std::size_t hits = 0;
    std::size_t inside = 0;
    std::size_t misses = 0;
    forRandomRays(200, [&](const DepthMap& map, const TileRay& ray, const TileWindow& window) {
        const auto hit = traceBilinear(map, ray, window, kMaxDistance);
        const auto wrong = violation(map, ray, window, hit, kMaxDistance);
        EXPECT_FALSE(wrong) << *wrong << ": " << describe(map, ray);
        ++(!hit ? misses : hit->startsInside ? inside : hits);
    });
    // The rays must exercise every outcome for the check to mean something.
    EXPECT_GT(hits, 10000u);
    EXPECT_GT(inside, 10000u);
    EXPECT_GT(misses, 10000u);
}

TEST(RandomRays, NeverBehindTheHitOfMarching) {
    std::size_t both = 0;
    std::size_t equal = 0;
    forRandomRays(40, [&](const DepthMap& map, const TileRay& ray, const TileWindow& window) {
        const auto hit = traceBilinear(map, ray, window, 100.0);
        const auto marched = marchToHit(map, ray, window, kMaxDistance, 64.0);
        if (!marched)
            return;
        ASSERT_TRUE(hit) << describe(map, ray);
        EXPECT_LE(hit->t, *marched + 1e-9) << describe(map, ray);
        ++both;
        equal += std::abs(hit->t - *marched) < 1e-9 ? 1 : 0;
    });
    // Marching misses shallow touches only, which are rare.
    EXPECT_GT(both, 3000u);
    EXPECT_GT(static_cast<double>(equal), 0.99 * static_cast<double>(both));
}

/// A wrong tracer that at least knows when it begins below the surface.
template <typename Trace>
Tracer knowingInside(const Trace& trace) {
    return [trace](const DepthMap& map, const TileRay& ray, const TileWindow& window) {
        auto hit = trace(map, ray, window, kMaxDistance);
        if (hit && depthBelow(map, ray, hit->t) > 1e-9)
            hit->startsInside = true;
        return hit;
    };
}

TEST(RandomRays, WrongTracersAreFound) {
    EXPECT_GT(violationsOf(knowingInside(traceCellBordersOnly)), 10u);
    EXPECT_GT(violationsOf(knowingInside(traceSkippingCells)), 200u);
}

TEST(RandomRays, ShiftByWholeTilesChangesNothing) {
    // Sizes and coordinates are binary fractions here, so the shifted ray is exactly the same ray.
    std::mt19937 random(7);
    std::uniform_int_distribution<int> sixtyFourths(0, 63);
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror}) {
        const DepthMap map = randomMap({16, 8}, wrap, random, false);
        for (int k = 0; k < 500; ++k) {
            TileRay ray = randomRay(map, Origin::Above, Course::Descending, random);
            ray.origin = {sixtyFourths(random) / 64.0, sixtyFourths(random) / 64.0, 0.0};
            const auto here = traceBilinear(map, ray);
            for (const glm::dvec2 tiles :
                 {glm::dvec2(2, 0), glm::dvec2(-4, 6), glm::dvec2(1e5, -1e5)}) {
                TileRay shifted = ray;
                shifted.origin += glm::dvec3(tiles, 0.0);
                const auto there = traceBilinear(map, shifted);
                ASSERT_EQ(here.has_value(), there.has_value());
                EXPECT_EQ(here->t, there->t) << describe(map, shifted);
            }
        }
    }
}

TEST(RandomRays, FarFromTheOriginStillFirstHits) {
    std::mt19937 random(8);
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp}) {
        const DepthMap map = randomMap({13, 7}, wrap, random, false);
        for (int k = 0; k < 200; ++k) {
            TileRay ray = randomRay(map, Origin::Above, Course::Descending, random);
            const auto near = traceBilinear(map, ray);
            ray.origin += glm::dvec3(99998.0, -99998.0, 0.0);
            const auto hit = traceBilinear(map, ray);
            ASSERT_TRUE(near && hit);
            // Coordinates near 1e5 are rounded to 1.5e-11 tiles: 1e-10 of depth on these slopes.
            EXPECT_NEAR(depthBelow(map, ray, hit->t), 0.0, 1e-9) << describe(map, ray);
        }
    }
}

TEST(RandomRays, MirrorIsTheRepeatedMosaic) {
    std::mt19937 random(9);
    const DepthMap tile = randomMap({4, 8}, WrapMode::Mirror, random, false);
    DepthMap mosaic{textures::Plane(8, 16), WrapMode::Repeat};
    for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 8; ++i)
            mosaic.depth.at(i, j) = tile.at(i, j);
    for (int k = 0; k < 500; ++k) {
        const TileRay ray = randomRay(tile, Origin::Above, Course::Descending, random);
        TileRay halved = ray;
        halved.origin *= glm::dvec3(0.5, 0.5, 1.0);
        halved.direction *= glm::dvec3(0.5, 0.5, 1.0);
        const auto mirrored = traceBilinear(tile, ray);
        const auto repeated = traceBilinear(mosaic, halved);
        ASSERT_TRUE(mirrored && repeated);
        EXPECT_EQ(mirrored->t, repeated->t);
    }
}

}  // namespace
}  // namespace relievo::reference::test
