#include "textures/lattice_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relievo::textures {

namespace {

std::uint32_t mix(std::uint32_t value) noexcept {
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// The slope of the noise at a lattice point times the offset from it.
double gradientTerm(int cellX, int cellY, double dx, double dy, std::uint32_t seed) noexcept {
    constexpr double kDiagonal = 0.70710678118654752;
    constexpr std::array<std::array<double, 2>, 8> kGradients{{{1.0, 0.0},
                                                               {kDiagonal, kDiagonal},
                                                               {0.0, 1.0},
                                                               {-kDiagonal, kDiagonal},
                                                               {-1.0, 0.0},
                                                               {-kDiagonal, -kDiagonal},
                                                               {0.0, -1.0},
                                                               {kDiagonal, -kDiagonal}}};
    const std::array<double, 2>& gradient = kGradients[latticeHash(cellX, cellY, seed) >> 29u];
    return gradient[0] * dx + gradient[1] * dy;
}

/// Perlin's quintic: first and second derivatives vanish at the lattice points.
double fade(double t) noexcept {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

}  // namespace

std::uint32_t latticeHash(int x, int y, std::uint32_t seed) noexcept {
    return mix(mix(mix(seed) + static_cast<std::uint32_t>(x)) + static_cast<std::uint32_t>(y));
}

double latticeRandom(int x, int y, std::uint32_t seed) noexcept {
    return latticeHash(x, y, seed) / 4294967296.0;
}

int wrapCell(int index, int period) noexcept {
    const int rest = index % period;
    return rest < 0 ? rest + period : rest;
}

double gradientNoise(double x, double y, int periodX, int periodY, std::uint32_t seed) noexcept {
    const double floorX = std::floor(x), floorY = std::floor(y);
    const double fx = x - floorX, fy = y - floorY;
    const int x0 = wrapCell(static_cast<int>(floorX), periodX), x1 = (x0 + 1) % periodX;
    const int y0 = wrapCell(static_cast<int>(floorY), periodY), y1 = (y0 + 1) % periodY;
    const double top = std::lerp(gradientTerm(x0, y0, fx, fy, seed),
                                 gradientTerm(x1, y0, fx - 1.0, fy, seed), fade(fx));
    const double bottom = std::lerp(gradientTerm(x0, y1, fx, fy - 1.0, seed),
                                    gradientTerm(x1, y1, fx - 1.0, fy - 1.0, seed), fade(fx));
    constexpr double kToUnit = 1.4142135623730951;
    return kToUnit * std::lerp(top, bottom, fade(fy));
}

double fractalNoise(double x, double y, int periodX, int periodY, int octaves,
                    std::uint32_t seed) noexcept {
    double sum = 0.0;
    double amplitude = 1.0;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += amplitude * gradientNoise(x, y, periodX, periodY, seed + 101u * octave);
        amplitude *= 0.5;
        x *= 2.0;
        y *= 2.0;
        periodX *= 2;
        periodY *= 2;
    }
    return sum;
}

double smoothStep(double low, double high, double x) noexcept {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace relievo::textures
