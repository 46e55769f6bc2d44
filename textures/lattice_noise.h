#pragma once

#include <cstdint>

namespace relievo::textures {

/// Random numbers that belong to the cells of a lattice, from integer arithmetic only: the same on
/// every machine.

/// A well-mixed hash of a lattice cell and a seed (PCG output permutation).
std::uint32_t latticeHash(int x, int y, std::uint32_t seed) noexcept;

/// latticeHash as a number in [0,1).
double latticeRandom(int x, int y, std::uint32_t seed) noexcept;

/// The lattice cell `index` wrapped into [0,period), period ≥ 1.
int wrapCell(int index, int period) noexcept;

/// Gradient noise about in [-1,1] with zeros at the lattice points, of period `periodX` in x and
/// `periodY` in y (K. Perlin, Improving Noise, SIGGRAPH 2002; here with eight gradients).
double gradientNoise(double x, double y, int periodX, int periodY, std::uint32_t seed) noexcept;

/// `octaves` of gradientNoise, each of twice the frequency and half the amplitude of the one
/// before; (x,y) and the periods are in cells of the first.
double fractalNoise(double x, double y, int periodX, int periodY, int octaves,
                    std::uint32_t seed) noexcept;

/// 0 for x ≤ low, 1 for x ≥ high, and the cubic with level ends between.
double smoothStep(double low, double high, double x) noexcept;

}  // namespace relievo::textures
