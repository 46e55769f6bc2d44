#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace relievo::preprocess {

/// Texels of a shape map in the making, which follow each other. All spans are as long.
struct OrientedTexels {
    std::span<const std::uint8_t> inside;  ///< whether their centres are: 1 or 0
    std::span<float> distance;             ///< to the outline; of either sign once oriented
    std::span<float> awayX;                ///< unit vectors away from it; outwards once oriented
    std::span<float> awayY;
    std::span<float> shape;  ///< how much of them is inside, in [0,1]
};

/// Turns distances inside, and the directions that go with them, to the other sign, and draws
/// coverage that contradicts a texel's centre to 1/2.
void orientTexels(const OrientedTexels& texels);

/// What distances that measureBoundaryDistances found may be off: so much of the distance and the
/// length of the longest segment together, and so many texels.
inline constexpr double kMeasuredRelativeError = 0x1p-21;
inline constexpr double kMeasuredAbsoluteError = 1e-6;

/// Takes from distances of either sign, in texels, what they may be off where segments are at most
/// `longest` texels long, and rounds them towards 0, as floats in tile widths of `width` texels.
/// Returns the most that true ones may be farther from 0, in tile widths.
double makeDistancesSure(std::span<float> distances, int width, double longest);

/// A distance ≥ 0 in texels as a float in tile widths that is nowhere too large.
float towardsZero(double texels, int width);

}  // namespace relievo::preprocess
