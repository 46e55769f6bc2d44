#include "solids/free_space.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "small_shapes.h"
#include "textures/bilinear.h"

namespace relievo::solids {
namespace {

using textures::WrapMode;

constexpr std::array kWraps{WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

// How often d, `factor` times its radius away, is in a range that the radius keeps clear.
int countBroken(const textures::ShapeMap& map, const FreeSpace& space, double factor,
                std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1.0, 2.0);
    int broken = 0;
    for (int k = 0; k < 20000; ++k) {
        const glm::dvec2 p(unit(random), unit(random));
        const double d = textures::sampleBilinear(map.distance, p.x, p.y, map.wrap);
        const double offset = 0.3 * unit(random);
        const double radius = factor * space.radius(d, offset, offset);
        const double angle = 6.283185307179586 * unit(random);
        const glm::dvec2 q =
            p + radius * glm::dvec2(std::cos(angle) / map.width(), std::sin(angle) / map.height());
        const double there = textures::sampleBilinear(map.distance, q.x, q.y, map.wrap);
        broken += d > offset ? there < offset : there > offset;
    }
    return broken;
}

TEST(FreeSpace, IsFree) {
    std::mt19937_64 random(20311);
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair(16, 16), {13, 7}, {1, 5}, {1, 1}}) {
            const auto discs = randomDiscs(width, height, wrap, random);
            const FreeSpace distances(*discs, wrap, true);
            EXPECT_TRUE(distances.isDistance());
            EXPECT_EQ(countBroken(*discs, distances, 1.0, random), 0);
            const auto texels = randomTexels(width, height, wrap, random);
            const FreeSpace any(*texels, wrap, false);
            EXPECT_EQ(countBroken(*texels, any, 1.0, random), 0);
        }
}

TEST(FreeSpace, DurationsKeepClearOfMovingOffsets) {
    std::mt19937_64 random(20315);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto map = randomDiscs(16, 16, WrapMode::Repeat, random);
    const FreeSpace space(*map, WrapMode::Repeat, true);
    int broken = 0;
    int overstepped = 0;
    for (int k = 0; k < 20000; ++k) {
        const glm::dvec2 p(unit(random), unit(random));
        const double angle = 6.283185307179586 * unit(random);
        const double speed = 16.0 * unit(random);
        const double closing = 2.0 * unit(random) - 0.5;
        const double d = textures::sampleBilinear(map->distance, p.x, p.y, map->wrap);
        const double offset = d - 0.2 * unit(random);
        const double duration = space.duration(d, d - offset, closing, speed);
        for (const double factor : {1.0, 2.0}) {
            const double t = factor * std::min(duration, 10.0);
            const glm::dvec2 q =
                p + t * speed / 16.0 * glm::dvec2(std::cos(angle), std::sin(angle));
            const double there = textures::sampleBilinear(map->distance, q.x, q.y, map->wrap);
            (factor > 1.0 ? overstepped : broken) += there < offset + t * closing;
        }
    }
    EXPECT_EQ(broken, 0);
    EXPECT_GT(overstepped, 0);
}

TEST(FreeSpace, HoldsWithRoundedDistances) {
    std::mt19937_64 random(20312);
    for (const WrapMode wrap : kWraps) {
        textures::ShapeMap map = *randomDiscs(16, 16, wrap, random);
        map.slack = 1.0 / 64.0;
        for (float& d : map.distance.texels)
            d = std::trunc(d * 64.0f) / 64.0f;
        EXPECT_EQ(countBroken(map, FreeSpace(map, wrap, true), 1.0, random), 0);
    }
}

TEST(FreeSpace, CheckCatchesTheDistanceItself) {
    // Stepping by d, as if the bilinear interpolation of a distance had no slope above 1.
    std::mt19937_64 random(20313);
    const std::vector<Disc> discs{{{0.5, 0.5}, 0.1}};
    const auto map = discShape(8, 8, WrapMode::Repeat, discs);
    int broken = 0;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int k = 0; k < 100000; ++k) {
        const glm::dvec2 p(unit(random), unit(random));
        const double d = textures::sampleBilinear(map->distance, p.x, p.y, map->wrap);
        const double angle = 6.283185307179586 * unit(random);
        const glm::dvec2 q = p + std::max(0.0, d) * glm::dvec2(std::cos(angle), std::sin(angle));
        broken += textures::sampleBilinear(map->distance, q.x, q.y, map->wrap) < 0.0 && d > 0.0;
    }
    EXPECT_GT(broken, 0);
}

TEST(FreeSpace, DoesNotBelieveWhatCanBeNoDistance) {
    std::mt19937_64 random(20314);
    const auto texels = randomTexels(8, 8, WrapMode::Repeat, random);
    EXPECT_FALSE(FreeSpace(*texels, WrapMode::Repeat, true).isDistance());
    const auto constant = shapeOf(4, 4, WrapMode::Repeat, [](const glm::dvec2&) { return 0.25; });
    EXPECT_GT(FreeSpace(*constant, WrapMode::Repeat, false).radius(0.25, 0.0, 0.0), 1e6);
    EXPECT_EQ(FreeSpace(*constant, WrapMode::Repeat, false).radius(0.25, 0.0, 0.3), 0.0);
}

}  // namespace
}  // namespace relievo::solids
