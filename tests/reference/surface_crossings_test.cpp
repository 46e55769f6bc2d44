// All crossings of random rays against dense sampling, and closed forms.
#include "reference/surface_crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "ray_oracle.h"

namespace relievo::reference::test {
namespace {

using textures::DepthMap;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr double kTolerance = 1e-3;  // coarse enough for sampling to see what it lets count
constexpr double kSamples = 20000;

DepthMap randomMap(int width, int height, WrapMode wrap, std::mt19937& random, bool binary) {
    DepthMap map{textures::Plane(width, height), wrap};
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    for (float& depth : map.depth.texels)
        depth = binary ? std::round(value(random)) : value(random);
    return map;
}

TileRay randomRay(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double azimuth = random() % 4 == 0
                               ? 0.5 * std::numbers::pi * static_cast<double>(random() % 4)
                               : 2.0 * std::numbers::pi * unit(random);
    return {{3.0 * unit(random) - 1.0, 3.0 * unit(random) - 1.0, unit(random)},
            {std::cos(azimuth), std::sin(azimuth), 0.5 * unit(random) - 0.25}};
}

// The crossings that samples in a dense row see, by the definition itself.
std::vector<SurfaceCrossing> sampledCrossings(const DepthMap& map, const TileRay& ray, double end) {
    std::vector<SurfaceCrossing> crossings;
    std::optional<bool> below;
    double candidate = 0.0;
    double before = depthBelow(map, ray, 0.0);
    for (int k = 0; k <= static_cast<int>(kSamples); ++k) {
        const double t = end * k / kSamples;
        const double depth = depthBelow(map, ray, t);
        if ((before <= 0.0) != (depth <= 0.0))
            candidate = t;
        before = depth;
        if (std::abs(depth) <= kTolerance || below == (depth > 0.0))
            continue;
        if (below || (depth > 0.0 && k > 0))
            crossings.push_back({candidate, depth > 0.0});
        below = depth > 0.0;
    }
    return crossings;
}

using Finder =
    std::function<std::vector<SurfaceCrossing>(const DepthMap&, const TileRay&, double end)>;

struct Comparison {
    int rays = 0;
    int crossings = 0;
    int wrong = 0;
};

Comparison compareWithSamples(const Finder& find) {
    std::mt19937 random(5);
    Comparison comparison;
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {5, 1}, {2, 2}, {7, 5}, {23, 11}})
        for (const WrapMode wrap : kWraps)
            for (const bool binary : {false, true}) {
                const DepthMap map = randomMap(width, height, wrap, random, binary);
                for (int k = 0; k < 12; ++k) {
                    const TileRay ray = randomRay(random);
                    const auto found = find(map, ray, 1.0);
                    const auto sampled = sampledCrossings(map, ray, 1.0);
                    bool same = found.size() == sampled.size();
                    for (std::size_t c = 0; same && c < found.size(); ++c)
                        same = found[c].enters == sampled[c].enters &&
                               std::abs(found[c].t - sampled[c].t) < 2.0 / kSamples;
                    ++comparison.rays;
                    comparison.crossings += static_cast<int>(found.size());
                    comparison.wrong += same ? 0 : 1;
                }
            }
    return comparison;
}

TEST(SurfaceCrossings, AreThoseThatDenseSamplesSee) {
    const Comparison comparison =
        compareWithSamples([](const DepthMap& map, const TileRay& ray, double end) {
            return surfaceCrossings(map, ray, end, kTolerance);
        });
    EXPECT_GT(2 * comparison.crossings, 3 * comparison.rays);
    // An extreme within a hair of the tolerance may be seen by one and not by the other.
    EXPECT_LE(comparison.wrong, 1);
}

TEST(SurfaceCrossings, TheComparisonSeesWhatIsWrong) {
    const Comparison firstOnly =
        compareWithSamples([](const DepthMap& map, const TileRay& ray, double end) {
            auto crossings = surfaceCrossings(map, ray, end, kTolerance);
            crossings.resize(std::min<std::size_t>(crossings.size(), 1));
            return crossings;
        });
    EXPECT_GT(firstOnly.wrong, firstOnly.rays / 4);
    const Comparison otherTolerance =
        compareWithSamples([](const DepthMap& map, const TileRay& ray, double end) {
            return surfaceCrossings(map, ray, end, 50.0 * kTolerance);
        });
    EXPECT_GT(otherTolerance.wrong, 10);
}

TEST(SurfaceCrossings, FirstEntryIsTheFirstHit) {
    std::mt19937 random(6);
    int hits = 0;
    for (int k = 0; k < 400; ++k) {
        const DepthMap map = randomMap(9, 6, kWraps[k % 3], random, k % 2 == 0);
        TileRay ray = randomRay(random);
        ray.origin.z = 0.0;
        ray.direction.z = std::abs(ray.direction.z) + 0.01;
        const auto hit = traceBilinear(map, ray);
        ASSERT_TRUE(hit);
        const auto crossings = surfaceCrossings(map, ray, 1.1 * hit->t + 0.1, 0.0);
        ASSERT_FALSE(crossings.empty());
        EXPECT_TRUE(crossings.front().enters);
        EXPECT_NEAR(crossings.front().t, hit->t, 1e-12);
        ++hits;
    }
    EXPECT_EQ(hits, 400);
}

TEST(SurfaceCrossings, LevelRayThroughATriangleWave) {
    // D falls from 1 to 0 over four texels and rises again: level rays at depth z meet it where
    // |x − 4k| = 4z, texel centres at x = 0, 1, ….
    DepthMap map{textures::Plane(8, 1), WrapMode::Repeat};
    for (int i = 0; i < 8; ++i)
        map.depth.at(i, 0) = static_cast<float>(std::abs(i - 4)) / 4.0f;
    const double start = 0.5 / 8.0;  // centre of texel 0, the bottom of the valley
    for (const double z : {0.25, 0.5, 0.8}) {
        const auto crossings = surfaceCrossings(map, {{start, 0.3, z}, {1.0, 0.0, 0.0}}, 2.0);
        ASSERT_EQ(crossings.size(), 4u) << z;
        for (int tile = 0; tile < 2; ++tile) {
            EXPECT_NEAR(crossings[2 * tile].t, tile + (4.0 - 4.0 * z) / 8.0, 1e-12);
            EXPECT_NEAR(crossings[2 * tile + 1].t, tile + (4.0 + 4.0 * z) / 8.0, 1e-12);
            EXPECT_TRUE(crossings[2 * tile].enters);
            EXPECT_FALSE(crossings[2 * tile + 1].enters);
        }
    }
    // Along the crest from a tolerance below and above: no crossing, only an excursion.
    EXPECT_TRUE(surfaceCrossings(map, {{start, 0.3, 5e-7}, {1.0, 0.0, 0.0}}, 2.0).empty());
    EXPECT_NEAR(deepestBelow(map, {{start, 0.3, 5e-7}, {1.0, 0.0, 0.0}}, 2.0).depth, 5e-7, 1e-15);
    EXPECT_EQ(deepestBelow(map, {{start, 0.3, -5e-7}, {1.0, 0.0, 0.0}}, 2.0).depth, 0.0);
}

TEST(SurfaceCrossings, RayThatBeginsBelowHasAnExitFirst) {
    DepthMap map{textures::Plane(2, 1), WrapMode::Repeat};
    map.depth.at(0, 0) = 0.0f;
    map.depth.at(1, 0) = 1.0f;
    const auto crossings = surfaceCrossings(map, {{0.25, 0.5, 0.5}, {1.0, 0.0, 0.0}}, 1.0);
    ASSERT_EQ(crossings.size(), 2u);
    EXPECT_FALSE(crossings[0].enters);
    EXPECT_NEAR(crossings[0].t, 0.25, 1e-12);
    EXPECT_TRUE(crossings[1].enters);
    EXPECT_NEAR(crossings[1].t, 0.75, 1e-12);
}

TEST(Excursions, AreTheExtremesOfDenseSamples) {
    std::mt19937 random(7);
    int reappeared = 0;
    for (int k = 0; k < 200; ++k) {
        const DepthMap map = randomMap(7, 5, kWraps[k % 3], random, k % 2 == 0);
        const TileRay ray = randomRay(random);
        double deepest = 0.0;
        double farthest = 0.0;
        bool pierced = false;
        for (int sample = 0; sample <= 4000; ++sample) {
            const double depth = depthBelow(map, ray, sample / 4000.0);
            deepest = std::max(deepest, depth);
            pierced = pierced || depth > kTolerance;
            if (pierced)
                farthest = std::max(farthest, -depth);
        }
        const Excursion below = deepestBelow(map, ray, 1.0);
        const Excursion again = farthestReappearance(map, ray, 1.0, kTolerance);
        EXPECT_NEAR(below.depth, deepest, 5e-3);
        EXPECT_GE(below.depth, deepest - 1e-12);
        EXPECT_NEAR(again.depth, farthest, 5e-3);
        EXPECT_GE(again.depth, farthest - 1e-12);
        if (below.depth > 0.0) {
            EXPECT_NEAR(depthBelow(map, ray, below.t), below.depth, 1e-12);
        }
        if (again.depth > 0.0) {
            EXPECT_NEAR(depthBelow(map, ray, again.t), -again.depth, 1e-12);
            ++reappeared;
        }
    }
    EXPECT_GT(reappeared, 50);
}

}  // namespace
}  // namespace relievo::reference::test
