#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace relievo::textures {

/// The tile that a sample relief covers: 1 wide and `aspect` = height/width high, so that its
/// features are as wide as high whatever the size of the map.
struct SampleTile {
    double aspect = 1.0;
    std::uint32_t seed = 1;

    /// The number of rows that makes the cells of `columns` columns about square times `stretch`
    /// (the width of a cell over its height); a whole number, so that the tile repeats.
    [[nodiscard]] int rows(int columns, double stretch = 1.0) const noexcept {
        return std::max(1, static_cast<int>(std::floor(columns * stretch * aspect + 0.5)));
    }
};

/// A sample relief at one point.
struct SampleSurface {
    double depth = 0.0;      ///< D in [0,1]
    double feature = 1.0;    ///< 1 on a stone, letter …, 0 on the ground between them
    std::uint32_t part = 0;  ///< which stone, letter …: a hash that colours vary by
};

/// A relief: what it is at (u,v) in [0,1)² of `tile`. Periodic in both.
using SampleFunction = SampleSurface (*)(double u, double v, const SampleTile& tile);

}  // namespace relievo::textures
