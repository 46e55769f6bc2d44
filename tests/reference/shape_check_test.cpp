// The check of shape maps on distances in closed form, and what its step is worth.
#include "reference/shape_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "textures/bilinear.h"

namespace relievo::reference {
namespace {

using textures::Plane;
using textures::ShapeMap;
using textures::WrapMode;

// A disc in the middle of a tile, by the distances at texel centres as they are.
ShapeMap discMap(int width, int height, double radius, WrapMode wrap) {
    ShapeMap map{Plane(width, height), Plane(width, height), Plane(width, height),
                 Plane(width, height)};
    map.wrap = wrap;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double x = i + 0.5 - 0.5 * width;
            const double y = j + 0.5 - 0.5 * height;
            const double length = std::hypot(x, y);
            map.distance.at(i, j) = static_cast<float>((length - radius) / width);
            map.gradientX.at(i, j) = static_cast<float>(x / length);
            map.gradientY.at(i, j) = static_cast<float>(y / length);
            map.shape.at(i, j) = length <= radius ? 1.0f : 0.0f;
        }
    map.slack = 1e-7;
    return map;
}

ShapeCheckOptions rays(std::uint64_t count, std::uint64_t seed = 1) {
    ShapeCheckOptions options;
    options.rays = count;
    options.seed = seed;
    return options;
}

TEST(ShapeCheck, TrueDistancesPass) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] : {std::pair{64, 64}, {61, 43}, {1, 9}, {9, 1}, {2, 2}}) {
            const ShapeReport report =
                checkShape(discMap(width, height, 0.3 * width, wrap), rays(20000));
            EXPECT_EQ(report.violations, 0u) << width << " " << height;
            EXPECT_EQ(report.contradictions, 0u);
            EXPECT_FALSE(report.worst);
        }
}

TEST(ShapeCheck, TooLargeDistancesAreFoundAndCanBeTracedAgain) {
    for (const float factor : {1.1f, 1.02f}) {
        ShapeMap map = discMap(64, 48, 14.0, WrapMode::Clamp);
        for (float& distance : map.distance.texels)
            distance *= factor;
        const ShapeReport report = checkShape(map, rays(40000));
        EXPECT_GT(report.violations, 0u) << factor;
        ASSERT_TRUE(report.worst);
        const glm::dvec3 place =
            report.worst->step.origin + report.worst->worstAt * report.worst->step.direction;
        EXPECT_NEAR(place.z - textures::sampleBilinear(map.distance, place.x, place.y, map.wrap),
                    report.worst->depth, 1e-9);
    }
}

// With creases steps go by a field of their own, which may be no steeper than distances are; where
// corners have ended these themselves may not be.
TEST(ShapeCheck, OfCreasesStepsAreChecked) {
    ShapeMap map = discMap(64, 64, 20.0, WrapMode::Clamp);
    map.creases = {Plane(64, 64), map.distance};
    EXPECT_EQ(checkShape(map, rays(40000)).violations, 0u);
    const ShapeMap sound = map;
    // Distances that fall faster at the outline do not matter, as long as steps are below them.
    const auto end = static_cast<float>(textures::kCornersEndTexels - std::sqrt(2.0)) / 64.0f;
    for (float& distance : map.distance.texels)
        distance = std::max(std::min(distance, 3.0f * distance - 2.0f * end), -end);
    map.creases.step = map.distance;
    for (std::size_t t = 0; t < sound.distance.texels.size(); ++t)
        map.creases.step.texels[t] = std::min(sound.distance.texels[t] - 3.0f * end, -end);
    EXPECT_EQ(checkShape(map, rays(40000)).violations, 0u);
    // But farther out they do.
    for (float& distance : map.distance.texels)
        distance *= distance > end ? 1.2f : 1.0f;
    EXPECT_GT(checkShape(map, rays(40000)).violations, 0u);
    map = sound;
    for (float& step : map.creases.step.texels)
        step *= step > 0.0f ? 1.2f : 1.0f;
    EXPECT_GT(checkShape(map, rays(40000)).violations, 0u);
}

TEST(ShapeCheck, SlackMakesUpForRounding) {
    ShapeMap map = discMap(64, 64, 20.0, WrapMode::Clamp);
    std::mt19937 random(4);
    for (float& distance : map.distance.texels)
        distance *= 1.0f - 0.02f * static_cast<float>(random() % 1000) / 1000.0f;
    EXPECT_GT(checkShape(map, rays(100000)).violations, 0u);
    map.slack = 0.02 * 26.0 / 64.0;
    EXPECT_EQ(checkShape(map, rays(100000)).violations, 0u);
}

TEST(ShapeCheck, ContradictionsAreCounted) {
    ShapeMap map = discMap(32, 32, 9.0, WrapMode::Repeat);
    map.shape.at(16, 16) = 0.4f;
    map.shape.at(1, 1) = 0.6f;
    map.shape.at(2, 1) = 0.5f;
    EXPECT_EQ(checkShape(map, rays(10)).contradictions, 2u);
}

TEST(ShapeCheck, DoesNotDependOnTheOrderOfRays) {
    ShapeMap map = discMap(32, 32, 9.0, WrapMode::Repeat);
    for (float& distance : map.distance.texels)
        distance *= 1.1f;
    const ShapeReport first = checkShape(map, rays(30000, 7));
    const ShapeReport second = checkShape(map, rays(30000, 7));
    EXPECT_EQ(first.violations, second.violations);
    EXPECT_EQ(first.worst->ray, second.worst->ray);
    EXPECT_EQ(first.meanStep, second.meanStep);
    EXPECT_NE(checkShape(map, rays(30000, 8)).worst->ray, first.worst->ray);
}

// The least of the bilinear distances that are as near as `reach` to a place over the sampled
// distance to one point, as the worst choice of directions finds it.
double leastAround(const std::array<double, 9>& samples, double x, double y, double reach) {
    const auto at = [&](double u, double v) {
        const int i = std::clamp(static_cast<int>(std::floor(u)), 0, 1);
        const int j = std::clamp(static_cast<int>(std::floor(v)), 0, 1);
        const auto s = [&](int di, int dj) {
            return samples[static_cast<std::size_t>(3 * (j + dj) + i + di)];
        };
        const double fx = u - i;
        const double fy = v - j;
        return (1 - fy) * ((1 - fx) * s(0, 0) + fx * s(1, 0)) +
               fy * ((1 - fx) * s(0, 1) + fx * s(1, 1));
    };
    double least = at(x, y);
    for (int k = 0; k < 64; ++k) {
        const double angle = 2.0 * M_PI * k / 64;
        const double u = x + reach * std::cos(angle);
        const double v = y + reach * std::sin(angle);
        if (u >= 0.0 && v >= 0.0 && u <= 2.0 && v <= 2.0)
            least = std::min(least, at(u, v));
    }
    return least;
}

// A step as long as the distance itself is not safe on interpolated distances; the safe one is.
TEST(ShapeCheck, TheSafeStepIsShorterThanTheDistanceForAReason) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0.0, 2.0);
    int entered = 0;
    for (int k = 0; k < 20000; ++k) {
        const double px = unit(random);
        const double py = unit(random);
        std::array<double, 9> samples{};
        for (int t = 0; t < 9; ++t)
            samples[static_cast<std::size_t>(t)] = std::hypot(t % 3 - px, t / 3 - py);
        const double x = unit(random);
        const double y = unit(random);
        const double here = leastAround(samples, x, y, 0.0);
        const double offset = unit(random) * 0.5 * here;
        const double free = here - offset;
        EXPECT_GE(leastAround(samples, x, y, safeStep(free)), offset - 1e-12);
        entered += leastAround(samples, x, y, free) < offset - 1e-12 ? 1 : 0;
    }
    EXPECT_GT(entered, 100);
    EXPECT_EQ(safeStep(0.0), 0.0);
    EXPECT_NEAR(safeStep(100.0), 100.0, 0.003);
}

}  // namespace
}  // namespace relievo::reference
