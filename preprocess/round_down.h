#pragma once

#include <cmath>
#include <limits>

namespace relievo::preprocess {

/// The largest float that is not above `value` ≥ 0: cones are rounded to the safe side. Finite
/// values stay finite.
inline float roundDown(double value) {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) > value ? std::nextafter(nearest, 0.0f) : nearest;
}

/// The cone of a slope (depth per texel width) over a map of so many texels a row: its ratio in
/// tile widths per unit of depth, rounded down; unlimited over no slope.
inline float ratioOfSlope(double slope, int width) {
    return slope > 0.0 ? roundDown(1.0 / (slope * width)) : std::numeric_limits<float>::infinity();
}

/// Undoes what a handful of double operations may have rounded up: each adds half an epsilon.
inline double belowRounding(double value) {
    return value * (1.0 - 8.0 * std::numeric_limits<double>::epsilon());
}

}  // namespace relievo::preprocess
