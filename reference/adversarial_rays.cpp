#include "reference/adversarial_rays.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "reference/cell_walk.h"

namespace relievo::reference {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastElevation = 0.01 * kPi / 180.0;

struct Candidate {
    std::int64_t i = 0;
    std::int64_t j = 0;
    double squaredDistance = 0.0;
    double squaredRise = 0.0;  // 0: no higher than the place

    [[nodiscard]] bool isSteeperThan(const Candidate& other) const {
        return squaredRise * other.squaredDistance > other.squaredRise * squaredDistance;
    }
};

// What drawing a target needs; the place is in texels, relative to texel centres.
struct Surroundings {
    const textures::DepthMap& map;
    glm::dvec2 place;
    double depth;

    [[nodiscard]] Candidate candidate(std::int64_t i, std::int64_t j) const {
        const double across = static_cast<double>(i) - place.x;
        const double down = map.texelAspect * (static_cast<double>(j) - place.y);
        const double rise = std::max(depth - static_cast<double>(map.at(i, j)), 0.0);
        return {i, j, across * across + down * down, rise * rise};
    }
};

// From a texel at a random distance to better and better ones around it.
Candidate climb(const Surroundings& around, RayNumbers& numbers) {
    constexpr int kMoves = 4;
    const double reach = std::max(around.map.width(), around.map.height());
    const double radius = numbers.logarithmic(0.5, 0.5 * reach + 1.0);
    const double azimuth = 2.0 * kPi * numbers.unit();
    Candidate best = around.candidate(
        std::llround(around.place.x + radius * std::cos(azimuth)),
        std::llround(around.place.y + radius * std::sin(azimuth) / around.map.texelAspect));
    for (int move = 0; move < kMoves; ++move) {
        const Candidate from = best;
        for (std::int64_t j = from.j - 1; j <= from.j + 1; ++j)
            for (std::int64_t i = from.i - 1; i <= from.i + 1; ++i)
                if (const Candidate other = around.candidate(i, j); other.isSteeperThan(best))
                    best = other;
        if (best.i == from.i && best.j == from.j)
            break;
    }
    return best;
}

std::optional<Heading> headingToTarget(const Surroundings& around, RayNumbers& numbers) {
    Candidate best = climb(around, numbers);
    if (const Candidate other = climb(around, numbers); other.isSteeperThan(best))
        best = other;
    const double distance = std::sqrt(best.squaredDistance);
    if (best.squaredRise == 0.0 || distance == 0.0)
        return std::nullopt;
    const glm::dvec2 texels = glm::dvec2(best.i, best.j) - around.place;
    const glm::dvec2 size(around.map.width(), around.map.height());
    const double tiles = distance / around.map.width();
    return Heading{texels / size / tiles,
                   Heading::Target{tiles, static_cast<double>(around.map.at(best.i, best.j))}};
}

// The direction at an angle in the metric, in (u,v).
Heading towards(const textures::DepthMap& map, double azimuth) {
    return {{std::cos(azimuth), std::sin(azimuth) / map.aspect()}, std::nullopt};
}

Heading alongTheGrid(const textures::DepthMap& map, RayNumbers& numbers) {
    constexpr std::array<glm::dvec2, 8> kSteps{
        {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    const glm::dvec2 step = kSteps[static_cast<std::size_t>(numbers.below(8))];
    const double length = std::hypot(step.x, map.texelAspect * step.y) / map.width();
    return {step / glm::dvec2(map.width(), map.height()) / length, std::nullopt};
}

Heading upTheSlope(const textures::DepthMap& map, const glm::dvec2& place, RayNumbers& numbers) {
    const CellWalk walk(map, {place, 0.0}, glm::dvec3(0.0), 0.0);
    const glm::dvec2 slope = walk.surface().gradient(walk.local(0.0));
    if (slope.x == 0.0 && slope.y == 0.0)
        return towards(map, 2.0 * kPi * numbers.unit());
    return towards(map, std::atan2(-slope.y / map.texelAspect, -slope.x));
}

double drawElevation(RayNumbers& numbers) {
    if (numbers.below(8) == 0)
        return 0.0;
    return numbers.logarithmic(kLeastElevation, 0.5 * kPi);
}

TileRay rayFrom(const glm::dvec2& place, double z, const Heading& heading, double elevation) {
    return {{place, z}, {heading.direction * std::cos(elevation), std::sin(elevation)}};
}

// Where a texel's square and the bilinear cells have their corners and borders: a coordinate in
// [0,1) of the square.
double drawFraction(RayNumbers& numbers) {
    switch (numbers.below(6)) {
        case 0:
            return 0.0;
        case 1:
            return numbers.logarithmic(1e-7, 1e-2);
        case 2:
            return 1.0 - numbers.logarithmic(1e-7, 1e-2);
        case 3:
            return 0.5;
        default:
            return numbers.unit();
    }
}

}  // namespace

RayNumbers::RayNumbers(std::uint64_t seed, std::uint64_t ray) noexcept : state_(seed) {
    state_ = next() + ray;
    state_ = next();
}

std::uint64_t RayNumbers::next() noexcept {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

double RayNumbers::unit() noexcept {
    return static_cast<double>(next() >> 11) * 0x1p-53;
}

int RayNumbers::below(int count) noexcept {
    return static_cast<int>(unit() * count);
}

double RayNumbers::logarithmic(double low, double high) noexcept {
    return low * std::pow(high / low, unit());
}

glm::dvec2 drawPlace(const textures::DepthMap& map, RayNumbers& numbers) {
    const glm::dvec2 texel(numbers.below(map.width()), numbers.below(map.height()));
    const double across = drawFraction(numbers);
    const double down = drawFraction(numbers);
    return (texel + glm::dvec2(across, down)) / glm::dvec2(map.width(), map.height());
}

Heading drawHeading(const textures::DepthMap& map, const glm::dvec2& place, double depth,
                    RayNumbers& numbers) {
    const int kind = numbers.below(8);
    if (kind < 4) {
        const Surroundings around{map, place * glm::dvec2(map.width(), map.height()) - 0.5, depth};
        if (const std::optional<Heading> heading = headingToTarget(around, numbers))
            return *heading;
    }
    if (kind == 4)
        return alongTheGrid(map, numbers);
    if (kind == 5)
        return upTheSlope(map, place, numbers);
    return towards(map, 2.0 * kPi * numbers.unit());
}

std::optional<TileRay> drawRay(const glm::dvec2& place, double top, const Heading& heading,
                               RayNumbers& numbers) {
    if (!(top > 0.0))
        return std::nullopt;
    const double elevation = drawElevation(numbers);
    if (heading.target && heading.target->depth < top) {
        const auto [distance, depth] = *heading.target;
        const double aim = depth + (top - depth) * numbers.logarithmic(1e-5, 1.0);
        const double z = aim - distance * std::tan(elevation);
        if (z >= 0.0)
            return rayFrom(place, z, heading, elevation);
        const double higher = aim * numbers.unit();
        return rayFrom(place, higher, heading, std::atan((aim - higher) / distance));
    }
    const double gap =
        top * (numbers.below(2) == 0 ? 1.0 - numbers.unit() : numbers.logarithmic(1e-6, 1.0));
    return rayFrom(place, std::max(top - gap, 0.0), heading, elevation);
}

}  // namespace relievo::reference
