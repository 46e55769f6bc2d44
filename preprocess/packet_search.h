#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "preprocess/apex_block.h"

namespace relievo::preprocess {

/// Index of the apex in a column and row of a packet: quarter by quarter, each row by row.
constexpr std::size_t packetIndex(int column, int row) noexcept {
    const int quarter = column / kQuarterSize + 2 * (row / kQuarterSize);
    return static_cast<std::size_t>((quarter * kQuarterSize + row % kQuarterSize) * kQuarterSize +
                                    column % kQuarterSize);
}

/// Searches width × height apexes of a block packet by packet, row by row of them:
/// find(i, j, seeds, found) searches the packet whose first apex is (i,j). Found has slopes and
/// places, where the chords end, of a packet's apexes; seeds are the places that were found beside
/// the packet, to its left and above it, where chords are often steep here too.
///
/// Slopes beyond width and height are undefined.
template <typename Found, typename Find>
void searchInPackets(int width, int height, BlockValues& slopes, const Find& find) {
    using Place = typename decltype(Found::place)::value_type;
    static_assert(kBlockSize % kPacketSize == 0);
    std::array<Place, kBlockSize> above{};
    std::vector<Place> seeds;
    const auto addSeed = [&](const Place& place) {
        if (place.exists() && std::find(seeds.begin(), seeds.end(), place) == seeds.end())
            seeds.push_back(place);
    };
    Found found;
    for (int j = 0; j < height; j += kPacketSize) {
        std::array<Place, kPacketSize> before{};
        for (int i = 0; i < width; i += kPacketSize) {
            seeds.clear();
            for (int k = 0; k < kPacketSize; ++k) {
                addSeed(before[static_cast<std::size_t>(k)]);
                addSeed(above[static_cast<std::size_t>(i + k)]);
            }
            find(i, j, seeds, found);
            for (int k = 0; k < kPacketSize; ++k) {
                before[static_cast<std::size_t>(k)] = found.place[packetIndex(kPacketSize - 1, k)];
                above[static_cast<std::size_t>(i + k)] =
                    found.place[packetIndex(k, kPacketSize - 1)];
                for (int column = 0; column < kPacketSize; ++column)
                    slopes[blockIndex(i + column, j + k)] = found.slope[packetIndex(column, k)];
            }
        }
    }
}

}  // namespace relievo::preprocess
