#pragma once

#include <array>
#include <cstddef>

#include "preprocess/lanes.h"
#include "preprocess/slope_search.h"

namespace relievo::preprocess {

/// Maps are worked on in square blocks of texels. Their size is fixed: what is computed does not
/// depend on the number of threads.
inline constexpr int kBlockSize = 64;

/// A value for every texel of a block, row by row.
using BlockValues = std::array<float, static_cast<std::size_t>(kBlockSize) * kBlockSize>;

constexpr std::size_t blockIndex(int i, int j) noexcept {
    return static_cast<std::size_t>(j) * kBlockSize + static_cast<std::size_t>(i);
}

/// Which groups of kLanes texels beside each other are wanted: that of a texel is number
/// blockIndex / kLanes.
using BlockGroups = std::array<bool, static_cast<std::size_t>(kBlockSize) * kBlockSize / kLanes>;

/// A block of apexes at whole steps of a texel.
struct ApexBlock {
    float left = 0.0f;  ///< column and row of the first apex, in texels
    float top = 0.0f;
    int width = kBlockSize;  ///< apexes that are wanted, from the first on
    int height = kBlockSize;
    BlockValues depth;
    BlockValues known;  ///< slopes up to which nothing is of interest
};

/// Searches the slopes of all apexes of a block (slope_search.h), packet by packet. Each starts
/// from the ends of the chords found to its left and above it. Values beyond width and height are
/// undefined.
void findSlopes(SlopeSearch& search, const ApexBlock& block, BlockValues& slopes);

}  // namespace relievo::preprocess
