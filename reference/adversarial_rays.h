#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "reference/bilinear_tracer.h"
#include "textures/depth_map.h"

namespace relievo::reference {

/// The random numbers of one ray: a function of seed and ray alone (SplitMix64: Steele, Lea,
/// Flood 2014), so that rays can be drawn in any order and by any thread.
class RayNumbers {
  public:
    RayNumbers(std::uint64_t seed, std::uint64_t ray) noexcept;

    /// In [0,1), with 53 random bits.
    double unit() noexcept;
    /// One of 0 … count−1.
    int below(int count) noexcept;
    /// In [low, high), 0 < low < high, evenly spread over its logarithm.
    double logarithmic(double low, double high) noexcept;

  private:
    std::uint64_t next() noexcept;

    std::uint64_t state_;
};

/// A point (u,v) of the tile [0,1)² in a random texel: anywhere in its square, at or next to its
/// corners, on its borders, at its centre or on a border of the bilinear cells. A map that is
/// fetched per texel goes wrong at those first.
glm::dvec2 drawPlace(const textures::DepthMap& map, RayNumbers& numbers);

/// A direction over the surface, and the texel centre that it aims at, if any.
struct Heading {
    glm::dvec2 direction{1.0, 0.0};  ///< in (u,v), of metric length 1
    struct Target {
        double distance = 0.0;  ///< metric, in tile widths
        double depth = 0.0;     ///< D there, less than that of the place
    };
    std::optional<Target> target;
};

/// A heading from `place`, whose depth is `depth`: half of them at one of the texels around that
/// narrow an empty cone on the place the most, by a local search from random texels; others along
/// the axes and the diagonals of texels, up the steepest slope, and anywhere.
Heading drawHeading(const textures::DepthMap& map, const glm::dvec2& place, double depth,
                    RayNumbers& numbers);

/// A ray from (place, z), 0 ≤ z < `top`, that goes down or level along `heading`, its direction of
/// metric length 1 (a depth scale of 1): elevations from 90° to 0.01°, the grazing ones favoured,
/// and level ones; heights above `top` evenly spread, or with their logarithm. A ray with a target
/// passes closely below it. Nothing when top is 0.
std::optional<TileRay> drawRay(const glm::dvec2& place, double top, const Heading& heading,
                               RayNumbers& numbers);

}  // namespace relievo::reference
