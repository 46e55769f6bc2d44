#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>

#include "ray_check.h"
#include "small_shapes.h"
#include "solids/solid_tracer.h"

// Many random rays through solids of small random maps, compared with the implicit function.

namespace relievo::solids {
namespace {

using textures::WrapMode;

constexpr std::array kWraps{WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

// Whether two walks along a ray find the same crossings; where it only grazes, rounding may keep or
// drop a pair of them.
bool areSame(const std::vector<SolidCrossing>& a, const std::vector<SolidCrossing>& b,
             double speed) {
    const double tie = 1e-9 / speed;
    std::size_t i = 0;
    std::size_t j = 0;
    const auto skipsPair = [&](const std::vector<SolidCrossing>& list, std::size_t k) {
        return k + 1 < list.size() && list[k + 1].t - list[k].t < 1e-6 / speed;
    };
    while (i < a.size() || j < b.size()) {
        if (i < a.size() && j < b.size() &&
            std::abs(a[i].t - b[j].t) <= tie * (1.0 + a[i].t * speed))
            ++i, ++j;
        else if (skipsPair(a, i))
            i += 2;
        else if (skipsPair(b, j))
            j += 2;
        else
            return false;
    }
    return true;
}

// What goes wrong in `rays` random rays through a part and its window, without and with jumps;
// prints the first.
int countWrong(const SolidPart& part, int rays, int samples, bool isDistance,
               std::mt19937_64& random) {
    TraceOptions plain;
    plain.jumps = false;
    TraceOptions jumping;
    jumping.mapsAreDistances = isDistance;
    const SolidTracer walker({{part}}, plain);
    const SolidTracer jumper({{part}}, jumping);
    int wrong = 0;
    for (int k = 0; k < rays; ++k) {
        const SolidRay ray = randomRay(part.windowMinimum, part.windowMaximum, random);
        const double end = lastPlace(ray, part.windowMinimum, part.windowMaximum);
        const auto walked = walker.crossings(0, ray);
        const auto jumped = jumper.crossings(0, ray);
        auto found = disagreement(part, walked, ray, end, samples);
        if (!found && !areSame(walked, jumped, glm::length(ray.direction)))
            found = "jumps change the crossings";
        if (found && wrong++ == 0)
            ADD_FAILURE() << *found << "\norigin " << ray.origin.x << ' ' << ray.origin.y << ' '
                          << ray.origin.z << " direction " << ray.direction.x << ' '
                          << ray.direction.y << ' ' << ray.direction.z;
    }
    return wrong;
}

using RandomShape = std::shared_ptr<const textures::ShapeMap> (*)(int, int, WrapMode,
                                                                  std::mt19937_64&);

// The maps to go through, and how.
struct ExtrusionMaps {
    RandomShape shape;
    std::vector<std::pair<int, int>> sizes;
    bool areDistances = true;
    int rays = 500;
    int samples = 40;
};

// Over all wrap modes and profiles. `creased` counts the maps with creases.
int countWrongExtrusions(const ExtrusionMaps& maps, std::uint64_t seed, int* creased = nullptr) {
    std::mt19937_64 random(seed);
    int wrong = 0;
    for (const WrapMode wrap : kWraps)
        for (const Profile& profile : manyProfiles())
            for (const auto& [width, height] : maps.sizes) {
                SolidPart part = extrusion(maps.shape(width, height, wrap, random), profile);
                part.windowMinimum = {-1.3, -0.4, 0.0};
                part.windowMaximum = {1.7, 1.2, maps.areDistances ? 0.9 : 1.0};
                if (creased != nullptr)
                    *creased += part.solid.shape->isCreased() ? 1 : 0;
                wrong += countWrong(part, maps.rays, maps.samples, maps.areDistances, random);
            }
    return wrong;
}

const std::vector<std::pair<int, int>> kTinySizes{{1, 1}, {1, 5}, {6, 1}, {4, 4}, {7, 3}};

TEST(Extrusion, AgreesWithItsImplicitFunction) {
    EXPECT_EQ(countWrongExtrusions({randomDiscs, {{16, 16}, {13, 7}, {5, 11}}}, 20261), 0);
}

TEST(Extrusion, OfMapsThatAreNoDistancesAgreesToo) {
    EXPECT_EQ(countWrongExtrusions({randomTexels, kTinySizes, false, 200}, 20262), 0);
}

TEST(Extrusion, WithSharpCornersAgreesWithItsImplicitFunction) {
    int creased = 0;
    EXPECT_EQ(
        countWrongExtrusions({randomStar, {{32, 32}, {23, 17}}, true, 500, 60}, 20268, &creased),
        0);
    EXPECT_GT(creased, 30);
}

TEST(Extrusion, OfCreasesAnywhereAgreesToo) {
    int creased = 0;
    EXPECT_EQ(countWrongExtrusions({randomCreases, kTinySizes, false, 200, 60}, 20269, &creased),
              0);
    EXPECT_EQ(creased, 150);
}

TEST(Revolution, AgreesWithItsImplicitFunction) {
    std::mt19937_64 random(20263);
    int wrong = 0;
    for (const WrapMode wrap : kWraps)
        for (const double extension : {0.0, 0.06, -0.03})
            for (const glm::dvec2 axis : {glm::dvec2(0.5), glm::dvec2(0.3, 0.8)})
                for (const auto& [width, height] : {std::pair(16, 16), {13, 7}, {5, 11}}) {
                    SolidPart part = revolution(randomDiscs(width, height, WrapMode::Clamp, random),
                                                extension, axis);
                    auto shape = std::make_shared<textures::ShapeMap>(*part.solid.shape);
                    shape->wrap = wrap;
                    part.solid.shape = shape;
                    part.windowMinimum = {-1.3, -0.4, -0.7};
                    part.windowMaximum = {1.7, 1.2, 2.2};
                    wrong += countWrong(part, 300, 40, true, random);
                }
    EXPECT_EQ(wrong, 0);
}

TEST(Revolution, OfMapsThatAreNoDistancesAgreesToo) {
    std::mt19937_64 random(20264);
    int wrong = 0;
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair(1, 1), {1, 5}, {6, 1}, {4, 4}, {7, 3}}) {
            SolidPart part = revolution(randomTexels(width, height, wrap, random));
            part.windowMinimum = {-1.3, -0.4, -0.7};
            part.windowMaximum = {1.7, 1.2, 2.2};
            wrong += countWrong(part, 1000, 40, false, random);
        }
    EXPECT_EQ(wrong, 0);
}

TEST(Revolution, WithSharpCornersAndCreasesAnywhereAgrees) {
    std::mt19937_64 random(20270);
    int wrong = 0;
    for (const WrapMode wrap : kWraps)
        for (const double extension : {0.0, 0.06, -0.03})
            for (const bool isDistance : {true, false})
                for (const auto& [width, height] : {std::pair(24, 24), {15, 9}, {6, 1}}) {
                    SolidPart part =
                        revolution(isDistance ? randomStar(width, height, WrapMode::Clamp, random)
                                              : randomCreases(width, height, wrap, random),
                                   extension, {0.4, 0.6});
                    auto shape = std::make_shared<textures::ShapeMap>(*part.solid.shape);
                    shape->wrap = wrap;
                    part.solid.shape = shape;
                    part.windowMinimum = {-1.3, -0.4, -0.7};
                    part.windowMaximum = {1.7, 1.2, 2.2};
                    wrong += countWrong(part, 300, 60, isDistance, random);
                }
    EXPECT_EQ(wrong, 0);
}

// Lengths doubled: a map of another tool, of which jumps must not believe that it holds distances.
TEST(Extrusion, OfDoubledDistancesAgreesThoughCalledDistances) {
    std::mt19937_64 random(20265);
    int wrong = 0;
    long jumps = 0;
    for (const WrapMode wrap : kWraps)
        for (const Profile& profile : manyProfiles()) {
            SolidPart part = extrusion(randomDiscs(16, 12, wrap, random), profile);
            auto shape = std::make_shared<textures::ShapeMap>(*part.solid.shape);
            for (float& d : shape->distance.texels)
                d *= 2.0f;
            part.solid.shape = shape;
            wrong += countWrong(part, 200, 40, true, random);
            TraceCost cost;
            (void)SolidTracer({{part}}).firstHit({{0.0, 0.0, 0.5}, {1.0, 1.0, 0.1}}, &cost);
            jumps += cost.jumps;
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(jumps, 0);
}

TEST(Solids, AgreeWithVeryFineSamples) {
    std::mt19937_64 random(20266);
    int wrong = 0;
    for (const WrapMode wrap : kWraps) {
        SolidPart a = extrusion(randomDiscs(32, 24, wrap, random),
                                makeProfile(0.0, 0.2, 0.7, ProfileShape::Round));
        SolidPart b = revolution(randomDiscs(32, 24, wrap, random), 0.02);
        wrong += countWrong(a, 30, 10000, true, random);
        wrong += countWrong(b, 30, 10000, true, random);
    }
    EXPECT_EQ(wrong, 0);
}

TEST(Solids, AgreeThroughTenReplicas) {
    std::mt19937_64 random(20267);
    int wrong = 0;
    std::size_t crossings = 0;
    for (const WrapMode wrap : kWraps) {
        SolidPart a = extrusion(randomDiscs(16, 16, wrap, random), makeProfile(0.0, 0.1));
        SolidPart b = revolution(randomDiscs(16, 16, wrap, random), 0.0, {0.4, 0.5});
        for (SolidPart* part : {&a, &b}) {
            part->windowMinimum = {0.0, 0.0, 0.0};
            part->windowMaximum = {12.0, 12.0, part == &a ? 1.0 : 12.0};
            wrong += countWrong(*part, 300, 400, true, random);
            const SolidRay ray{{-1.0, 0.37, 0.3}, {1.0, 0.003, 0.02}};
            crossings += SolidTracer({{*part}}).crossings(0, ray).size();
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(crossings, 60u);
}

}  // namespace
}  // namespace relievo::solids
