// Maps that keep their promise by construction, and ones that break it in every way that matters.
#include "reference/guarantee_check.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

#include "ray_oracle.h"
#include "reference/adversarial_rays.h"
#include "reference/surface_crossings.h"
#include "safe_maps.h"
#include "textures/bilinear.h"

namespace relievo::reference::test {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr ConePromise kPromises[] = {ConePromise::Conservative, ConePromise::Relaxed};

GuaranteeCheckOptions rays(std::uint64_t count, std::uint64_t seed = 1) {
    GuaranteeCheckOptions options;
    options.rays = count;
    options.seed = seed;
    return options;
}

std::uint64_t violationsOf(const DepthMap& map, const Plane& ratio, ConePromise promise) {
    return checkCones(map, ratio, promise, rays(20000)).violations;
}

TEST(GuaranteeCheck, ConesOfTheSteepestSlopeAreSafe) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] :
             {std::pair(1, 7), {9, 1}, {2, 2}, {13, 17}, {64, 3}, {16, 16}}) {
            DepthMap map = noiseRelief(width, height, wrap, 3);
            for (const double texelAspect : {1.0, 0.8}) {
                map.texelAspect = texelAspect;
                for (const ConePromise promise : kPromises)
                    EXPECT_EQ(violationsOf(map, slopeCones(map), promise), 0u)
                        << width << "x" << height << " " << wrapModeName(wrap);
            }
        }
}

TEST(GuaranteeCheck, ConesHalfTooWideAreFound) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair(9, 2), {2, 2}, {13, 17}, {64, 3}, {16, 16}}) {
            DepthMap map = noiseRelief(width, height, wrap, 3);
            map.texelAspect = 0.8;
            EXPECT_GT(violationsOf(map, slopeCones(map, 1.5), ConePromise::Conservative), 0u)
                << width << "x" << height << " " << wrapModeName(wrap);
        }
}

// With the metric of square texels the cones of a level with flat texels are too wide.
TEST(GuaranteeCheck, UsesTheShapeOfTexels) {
    DepthMap map = noiseRelief(16, 16, WrapMode::Repeat, 4);
    const Plane square = slopeCones(map);
    map.texelAspect = 0.5;
    EXPECT_GT(violationsOf(map, square, ConePromise::Conservative), 0u);
    EXPECT_EQ(violationsOf(map, slopeCones(map), ConePromise::Conservative), 0u);
}

TEST(GuaranteeCheck, TheOnlyTexelWithAConeTooWideIsFound) {
    DepthMap map{Plane(32, 32, 1.0f), WrapMode::Repeat};
    map.depth.at(20, 20) = 0.0f;
    Plane ratio(32, 32, static_cast<float>(1.0 / 32.0 / std::sqrt(2.0)));
    EXPECT_EQ(checkCones(map, ratio, ConePromise::Conservative, rays(100000)).violations, 0u);
    ratio.at(18, 20) = static_cast<float>(2.2 / 32.0);  // from its near border to the spike: 1.5
    const auto report = checkCones(map, ratio, ConePromise::Conservative, rays(100000));
    EXPECT_GT(report.violations, 0u);
    ASSERT_TRUE(report.worst);
    EXPECT_EQ(report.worst->i, 18);
    EXPECT_EQ(report.worst->j, 20);
}

// A wall, 16 texels of depth 0 in a tile of 64, each side of it one texel wide. A ray is out again
// behind the far edge: a relaxed cone may reach to there, a conservative one not.
struct Wall {
    DepthMap map{Plane(64, 4, 1.0f), WrapMode::Repeat};
    Plane ratio{64, 4};

    explicit Wall(double factor) {
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 64; ++i) {
                if (i < 16)
                    map.depth.at(i, j) = 0.0f;
                // From the nearer border of the texel to the far edge on either side, in texels;
                // beside the wall, where the surface slopes, its slope.
                const double reach = std::min(i - 0.5, 64.0 + 15.0 - (i + 0.5));
                const bool isLevel = i > 16 && i < 63;
                ratio.at(i, j) = static_cast<float>(factor * (isLevel ? reach : 0.999) / 64.0);
            }
    }
};

TEST(GuaranteeCheck, RelaxedConesMayPierceOnce) {
    const Wall wall(1.0);
    EXPECT_EQ(violationsOf(wall.map, wall.ratio, ConePromise::Relaxed), 0u);
    EXPECT_GT(violationsOf(wall.map, wall.ratio, ConePromise::Conservative), 1000u);
    const Wall wide(1.2);
    const auto report = checkCones(wide.map, wide.ratio, ConePromise::Relaxed, rays(20000));
    EXPECT_GT(report.violations, 20u);
    // The step of the worst example does come out again.
    ASSERT_TRUE(report.worst);
    const auto crossings = surfaceCrossings(wide.map, report.worst->step, report.worst->length);
    ASSERT_GE(crossings.size(), 2u);
    EXPECT_FALSE(crossings[1].enters);
}

TEST(GuaranteeCheck, WorstExampleIsAsFarOffAsItSays) {
    const DepthMap map = noiseRelief(16, 16, WrapMode::Mirror, 5);
    const auto report =
        checkCones(map, slopeCones(map, 3.0), ConePromise::Conservative, rays(20000));
    ASSERT_TRUE(report.worst);
    const auto& [ray, i, j, step, length, worstAt, depth] = *report.worst;
    EXPECT_NEAR(depthBelow(map, step, worstAt), depth, 1e-9);
    EXPECT_LE(worstAt, length);
    EXPECT_LE(depthBelow(map, step, 0.0), 0.0);
    EXPECT_EQ(i, static_cast<int>(step.origin.x * 16));
    EXPECT_EQ(j, static_cast<int>(step.origin.y * 16));
    const auto hit = traceBilinear(map, step);
    ASSERT_TRUE(hit);
    EXPECT_LT(hit->t, worstAt);
}

TEST(GuaranteeCheck, UnlimitedConesOverAConstantMapAreSafeAndOverAnythingElseNot) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float depth : {0.0f, 0.5f, 1.0f}) {
        const DepthMap flat{Plane(7, 5, depth), WrapMode::Repeat};
        const auto report =
            checkCones(flat, Plane(7, 5, infinity), ConePromise::Conservative, rays(5000));
        EXPECT_EQ(report.violations, 0u);
        EXPECT_EQ(report.unlimited, 35u);
        EXPECT_EQ(report.meanRatio, 0.0);
    }
    const DepthMap rough = noiseRelief(7, 5, WrapMode::Clamp, 1);
    for (const ConePromise promise : kPromises)
        EXPECT_GT(violationsOf(rough, Plane(7, 5, infinity), promise), 100u);
    EXPECT_EQ(violationsOf(rough, Plane(7, 5, 0.0f), ConePromise::Conservative), 0u);
}

TEST(GuaranteeCheck, ReportDependsOnSeedAndNotOnThreads) {
    const DepthMap map = noiseRelief(32, 32, WrapMode::Repeat, 6);
    const Plane ratio = slopeCones(map, 2.0);
    const auto run = [&](int threads, std::uint64_t seed) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return checkCones(map, ratio, ConePromise::Conservative, rays(30000, seed));
    };
    const auto one = run(1, 1);
    const auto four = run(4, 1);
    EXPECT_EQ(one.violations, four.violations);
    ASSERT_TRUE(one.worst && four.worst);
    EXPECT_EQ(one.worst->ray, four.worst->ray);
    EXPECT_EQ(one.worst->depth, four.worst->depth);
    EXPECT_NE(run(2, 2).worst->ray, one.worst->ray);
}

TEST(AdversarialRays, AreAboveTheSurfaceAndGoDown) {
    DepthMap map = noiseRelief(13, 7, WrapMode::Mirror, 8);
    map.texelAspect = 1.3;
    int grazing = 0;
    int steep = 0;
    int aimed = 0;
    for (std::uint64_t ray = 0; ray < 20000; ++ray) {
        RayNumbers numbers(3, ray);
        const glm::dvec2 place = drawPlace(map, numbers);
        ASSERT_TRUE(place.x >= 0.0 && place.x < 1.0 && place.y >= 0.0 && place.y < 1.0);
        const double depth = textures::sampleBilinear(map.depth, place.x, place.y, map.wrap);
        const Heading heading = drawHeading(map, place, depth, numbers);
        EXPECT_NEAR(std::hypot(heading.direction.x, map.aspect() * heading.direction.y), 1.0,
                    1e-12);
        const auto drawn = drawRay(place, depth, heading, numbers);
        ASSERT_TRUE(drawn);
        EXPECT_GE(drawn->origin.z, 0.0);
        EXPECT_LT(drawn->origin.z, depth);
        EXPECT_GE(drawn->direction.z, 0.0);
        grazing += drawn->direction.z < std::sin(0.017) ? 1 : 0;
        steep += drawn->direction.z > 0.7 ? 1 : 0;
        aimed += heading.target ? 1 : 0;
        if (heading.target) {
            const glm::dvec2 target = place + heading.target->distance * heading.direction;
            EXPECT_NEAR(textures::sampleBilinear(map.depth, target.x, target.y, map.wrap),
                        heading.target->depth, 1e-6);
        }
    }
    EXPECT_GT(grazing, 8000);
    EXPECT_GT(steep, 500);
    EXPECT_GT(aimed, 8000);
}

}  // namespace
}  // namespace relievo::reference::test
