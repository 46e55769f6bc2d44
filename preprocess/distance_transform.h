#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// Squared distances in texels, row by row.
struct SquaredDistances {
    /// The distance where there is nothing to be distant from. Every other one is smaller.
    static constexpr std::uint32_t kUnlimited = UINT32_MAX;

    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> texels;
};

/// The exact squared Euclidean distance from every texel centre to the nearest texel of a set,
/// given row by row as one byte a texel, not 0 where the texel is in the set; kUnlimited everywhere
/// when it is empty. Repeat measures to the nearest copy; mirror and clamp need no copies: their
/// nearest is the texel of the tile itself.
///
/// `distances` takes the width and height of `set`; its memory is used again when it is large
/// enough. Throws textures::InputError for maps whose squared diagonal does not stay under 65535²
/// (46,340 texels square), for which 32 bits do not suffice.
///
/// Linear time: distances along columns, then the lower envelope of parabolas along rows (Meijster,
/// Roerdink and Hesselink 2000), in integers. Scratch memory: 128 bytes a row of the map and a few
/// rows, for each thread.
void measureDistances(std::span<const std::uint8_t> set, int width, int height,
                      textures::WrapMode wrap, SquaredDistances& distances);

/// The same in memory of its own.
SquaredDistances distancesTo(std::span<const std::uint8_t> set, int width, int height,
                             textures::WrapMode wrap);

}  // namespace relievo::preprocess
