#pragma once

#include <cstdint>
#include <vector>

#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// Squared distances in texels, row by row.
struct SquaredDistances {
    /// The distance where there is nothing to be distant from.
    static constexpr std::int64_t kUnlimited = INT64_MAX;

    int width = 0;
    int height = 0;
    std::vector<std::int64_t> texels;
};

/// The exact squared Euclidean distance from every texel centre to the nearest texel of a set,
/// given row by row as one byte a texel, not 0 where the texel is in the set; kUnlimited everywhere
/// when it is empty. Repeat measures to the nearest copy; mirror and clamp need no copies: their
/// nearest is the texel of the tile itself.
///
/// Linear time: distances along columns, then the lower envelope of parabolas along rows (Meijster,
/// Roerdink and Hesselink 2000), in integers.
SquaredDistances distancesTo(const std::vector<std::uint8_t>& set, int width, int height,
                             textures::WrapMode wrap);

}  // namespace relievo::preprocess
