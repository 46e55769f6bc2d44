// Searches on maps against the exact first hit: those that promise it have it for every ray, the
// others within their tolerance; and maps that are wrong give wrong hits.
#include "reference/map_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "reference/bilinear_tracer.h"
#include "reference/cone_search.h"
#include "reference/pyramid_search.h"
#include "reference/relaxed_search.h"
#include "reference/relief_search.h"
#include "reference/roof_search.h"
#include "safe_maps.h"
#include "textures/bilinear.h"
#include "textures/depth_pyramid.h"

namespace relievo::reference::test {
namespace {

using textures::DepthMap;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr double kDegree = std::numbers::pi / 180.0;

using Search = std::function<MapSearchResult(const DepthMap&, const DescendingRay&)>;

struct Outcome {
    int rays = 0;
    int wrong = 0;      // over 1e-9 of depth from the exact first hit
    int tunnelled = 0;  // over 1e-9 behind it
    double farthest = 0.0;
    double lookups = 0.0;
};

DescendingRay randomRay(const DepthMap& relief, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    constexpr double kElevations[] = {90.0, 60.0, 30.0, 10.0, 3.0};
    const double azimuth = random() % 4 == 0
                               ? 0.25 * std::numbers::pi * static_cast<double>(random() % 8)
                               : 2.0 * std::numbers::pi * unit(random);
    // Some begin at texel centres, where cells have their corners.
    glm::dvec2 start(3.0 * unit(random) - 1.0, 3.0 * unit(random) - 1.0);
    if (random() % 4 == 0)
        start = (glm::dvec2(random() % 7, random() % 7) + 0.5) /
                glm::dvec2(relief.width(), relief.height());
    return descendingRay(start, kElevations[random() % 5] * kDegree, azimuth, 0.3, relief.aspect());
}

double exactDepth(const DepthMap& relief, const DescendingRay& ray) {
    const auto hit = traceBilinear(relief, {{ray.start, 0.0}, {ray.slope, 1.0}}, {}, 1e4);
    EXPECT_TRUE(hit);
    return hit ? hit->position.z : 1.0;
}

// Of 150 rays over `relief`.
void tryRays(const DepthMap& relief, const Search& search, Outcome& outcome) {
    std::mt19937 random(9);
    for (int k = 0; k < 150; ++k) {
        const DescendingRay ray = randomRay(relief, random);
        const MapSearchResult result = search(relief, ray);
        const double error = result.z - exactDepth(relief, ray);
        ++outcome.rays;
        outcome.wrong += std::abs(error) > 1e-9 || !result.converged ? 1 : 0;
        outcome.tunnelled += error > 1e-9 ? 1 : 0;
        outcome.farthest = std::max(outcome.farthest, std::abs(error));
        outcome.lookups += result.lookups;
    }
}

// `prepare` makes the search for a relief from its maps.
Outcome tryMaps(std::initializer_list<WrapMode> wraps,
                const std::function<Search(const DepthMap&)>& prepare) {
    Outcome outcome;
    for (const WrapMode wrap : wraps)
        for (const auto& [width, height] :
             {std::pair(1, 1), {1, 5}, {6, 1}, {2, 2}, {8, 8}, {9, 5}})
            for (const bool isBinary : {false, true}) {
                const DepthMap relief = noiseRelief(width, height, wrap, 21, isBinary);
                tryRays(relief, prepare(relief), outcome);
            }
    return outcome;
}

Search roofSearch(const DepthMap& map, int layers, int block, int claimedBlock) {
    RoofMap roofs = bruteForceRoofs(map, layers, block);
    roofs.block = claimedBlock;
    return [roofs](const DepthMap& relief, const DescendingRay& ray) {
        return searchByRoofs(relief, roofs, ray);
    };
}

TEST(MapSearch, RoofsGiveTheFirstHit) {
    for (const int layers : {1, 4, 8})
        for (const int block : {1, 2}) {
            const Outcome outcome =
                tryMaps({WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp},
                        [&](const DepthMap& map) { return roofSearch(map, layers, block, block); });
            EXPECT_EQ(outcome.wrong, 0) << layers << " layers, block " << block;
            EXPECT_GT(outcome.rays, 1000);
        }
}

TEST(MapSearch, RoofsOfSmallerBlocksThanTheyClaimGiveWrongHits) {
    const Outcome outcome =
        tryMaps({WrapMode::Repeat}, [](const DepthMap& map) { return roofSearch(map, 4, 1, 3); });
    EXPECT_GT(outcome.tunnelled, 10);
}

Search pyramidSearch(const DepthMap& map) {
    const auto levels = textures::buildDepthPyramid(textures::leastDepthsOfCells(map)).levels;
    return [levels](const DepthMap& relief, const DescendingRay& ray) {
        return searchByPyramid(relief, levels, ray);
    };
}

TEST(MapSearch, PyramidGivesTheFirstHit) {
    const Outcome outcome = tryMaps({WrapMode::Repeat}, pyramidSearch);
    EXPECT_EQ(outcome.wrong, 0);
    const DepthMap clamped = noiseRelief(4, 4, WrapMode::Clamp, 1);
    EXPECT_THROW(pyramidSearch(clamped)(clamped, {}), std::invalid_argument);
}

TEST(MapSearch, ConesAndCellsGiveTheFirstHit) {
    const auto prepare = [](double factor) {
        return [factor](const DepthMap& map) -> Search {
            return [ratio = slopeCones(map, factor)](const DepthMap& relief,
                                                     const DescendingRay& ray) {
                return searchByConesAndCells(relief, ratio, ray);
            };
        };
    };
    EXPECT_EQ(tryMaps({WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp}, prepare(1.0)).wrong,
              0);
    EXPECT_GT(tryMaps({WrapMode::Repeat}, prepare(4.0)).tunnelled, 10);
}

TEST(MapSearch, RelaxedConesAndCellsGiveTheFirstHit) {
    const auto prepare = [](const DepthMap& map) -> Search {
        return [ratio = slopeCones(map)](const DepthMap& relief, const DescendingRay& ray) {
            return searchByRelaxedConesAndCells(relief, ratio, ray, {1e-4, 100000});
        };
    };
    EXPECT_EQ(tryMaps({WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp}, prepare).wrong, 0);
}

TEST(MapSearch, ConesStopWithinTheToleranceAboveTheSurface) {
    std::mt19937 random(4);
    const SearchEnd end{1e-5, 100000};
    for (const WrapMode wrap : kWraps) {
        const DepthMap relief = noiseRelief(9, 6, wrap, 3);
        const auto ratio = slopeCones(relief);
        for (int k = 0; k < 100; ++k) {
            const DescendingRay ray = randomRay(relief, random);
            const MapSearchResult result = searchByCones(relief, ratio, ray, end);
            EXPECT_TRUE(result.converged);
            EXPECT_LE(result.z, exactDepth(relief, ray) + 1e-9);
            const glm::dvec2 place = ray.at(result.z);
            EXPECT_LE(textures::sampleBilinear(relief.depth, place.x, place.y, wrap) - result.z,
                      1e-5);
            EXPECT_EQ(searchByRelaxedCones(relief, ratio, ray, 5, end).z, result.z);
        }
    }
    const DepthMap relief = noiseRelief(9, 6, WrapMode::Repeat, 3);
    const DescendingRay ray = descendingRay({0.1, 0.1}, 3.0 * kDegree, 1.0, 0.3, relief.aspect());
    const MapSearchResult early = searchByCones(relief, slopeCones(relief), ray, {1e-5, 3});
    EXPECT_FALSE(early.converged);
    EXPECT_EQ(early.lookups, 6);
}

TEST(MapSearch, RelaxedConesBisectTheStepThatPierces) {
    // A wall of 8 texels: the relaxed cone on the plain reaches to its far edge.
    DepthMap relief{textures::Plane(32, 1, 1.0f), WrapMode::Repeat};
    for (int i = 0; i < 8; ++i)
        relief.depth.at(i, 0) = 0.25f;
    const textures::Plane ratio(32, 1, 12.0f / 32.0f);
    const DescendingRay ray =
        descendingRay({12.5 / 32.0, 0.5}, 45.0 * kDegree, std::numbers::pi, 0.5, relief.aspect());
    const double exact = exactDepth(relief, ray);
    const MapSearchResult few = searchByRelaxedCones(relief, ratio, ray, 4);
    const MapSearchResult many = searchByRelaxedCones(relief, ratio, ray, 20);
    EXPECT_GE(many.z, exact);
    EXPECT_LT(many.z - exact, 1e-5);
    EXPECT_GT(few.z - exact, 1e-4);
    EXPECT_EQ(many.lookups, few.lookups + 16);
    EXPECT_NEAR(searchByRelaxedConesAndCells(relief, ratio, ray).z, exact, 1e-12);
}

TEST(MapSearch, LinearSearchMissesThinFeaturesAndIsCloseOtherwise) {
    DepthMap relief{textures::Plane(64, 1, 1.0f), WrapMode::Repeat};
    relief.depth.at(20, 0) = 0.0f;
    const DescendingRay ray = descendingRay({0.1, 0.5}, 5.0 * kDegree, 0.0, 0.3, relief.aspect());
    EXPECT_LT(exactDepth(relief, ray), 0.1);
    EXPECT_GT(searchLinearBinary(relief, ray, 4, 5).z, 0.2);
    const MapSearchResult fine = searchLinearBinary(relief, ray, 4000, 12);
    EXPECT_NEAR(fine.z, exactDepth(relief, ray), 1e-6);
    const DepthMap flat{textures::Plane(4, 4, 0.5f), WrapMode::Repeat};
    const MapSearchResult middle = searchLinearBinary(flat, ray);
    EXPECT_EQ(middle.z, 0.5);
    EXPECT_EQ(middle.lookups, 16 + 5);
}

TEST(MapSearch, LookupsAreCountedByTheDefinition) {
    // Nothing but a plain: each search sees the bottom at once.
    const DepthMap plain{textures::Plane(8, 8, 1.0f), WrapMode::Repeat};
    const DescendingRay ray = descendingRay({0.3, 0.3}, 0.5, 1.0, 0.3, 1.0);
    EXPECT_EQ(roofSearch(plain, 1, 1, 1)(plain, ray).lookups, 3);  // roof, roof at z = 1, cell
    EXPECT_EQ(pyramidSearch(plain)(plain, ray).lookups, 5);        // 8², 4², 2², 1², cell
    const textures::Plane wide(8, 8, 1e30f);
    EXPECT_EQ(searchByCones(plain, wide, ray).lookups, 3);  // depth, cone, depth
    EXPECT_EQ(searchByConesAndCells(plain, wide, ray).lookups, 3);
}

TEST(MapSearch, JumpsOfTheCellWalkNeverGoBack) {
    const DepthMap relief = noiseRelief(8, 8, WrapMode::Repeat, 2);
    CellWalk walk(relief, {0.5, 0.5, 0.0}, {0.25, -0.5, 1.0}, 1.0);  // texels (3.5, 3.5)
    walk.jump(0.5);                                                  // (4.5, 1.5)
    EXPECT_EQ(walk.columns().cell(), 4);
    EXPECT_EQ(walk.rows().cell(), 1);
    EXPECT_EQ(walk.entry(), 0.5);
    EXPECT_DOUBLE_EQ(walk.exit(), 0.625);
    walk.step();  // down to row 0
    EXPECT_EQ(walk.rows().cell(), 0);
    walk.jump(0.625 - 1e-12);  // a hair before the border that was just crossed
    EXPECT_EQ(walk.rows().cell(), 0);
    EXPECT_EQ(walk.columns().cell(), 4);
    EXPECT_GE(walk.exit(), walk.entry());
}

}  // namespace
}  // namespace relievo::reference::test
