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

/// Undoes what a handful of double operations may have rounded up: each adds half an epsilon.
inline double belowRounding(double value) {
    return value * (1.0 - 8.0 * std::numeric_limits<double>::epsilon());
}

}  // namespace relievo::preprocess
