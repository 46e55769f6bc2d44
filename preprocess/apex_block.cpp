#include "preprocess/apex_block.h"

#include <algorithm>
#include <vector>

namespace relievo::preprocess {
namespace {

static_assert(kBlockSize % kPacketSize == 0);

constexpr std::size_t apexOf(int column, int row) {
    return static_cast<std::size_t>(row * kPacketSize + column);
}

// The packet whose first apex is (i,j) of the block. At the border of what is wanted the last
// column and row stand in for those that are missing.
SlopePacket packetAt(const ApexBlock& block, int i, int j) {
    const auto columnAt = [&](int k) { return std::min(i + k, block.width - 1); };
    const auto rowAt = [&](int k) { return std::min(j + k, block.height - 1); };
    SlopePacket packet;
    for (int k = 0; k < kPacketSize; ++k) {
        packet.column[static_cast<std::size_t>(k)] = block.left + static_cast<float>(columnAt(k));
        packet.row[static_cast<std::size_t>(k)] = block.top + static_cast<float>(rowAt(k));
    }
    for (int row = 0; row < kPacketSize; ++row)
        for (int column = 0; column < kPacketSize; ++column) {
            const std::size_t from = blockIndex(columnAt(column), rowAt(row));
            packet.depth[apexOf(column, row)] = block.depth[from];
            packet.known[apexOf(column, row)] = block.known[from];
        }
    return packet;
}

void addSeed(SamplePlace place, std::vector<SamplePlace>& seeds) {
    if (place.i != SamplePlace::kNone &&
        std::find(seeds.begin(), seeds.end(), place) == seeds.end())
        seeds.push_back(place);
}

}  // namespace

void findSlopes(SlopeSearch& search, const ApexBlock& block, BlockValues& slopes) {
    std::array<SamplePlace, kBlockSize> above{};
    std::vector<SamplePlace> seeds;
    PacketSlopes found;
    for (int j = 0; j < block.height; j += kPacketSize) {
        std::array<SamplePlace, kPacketSize> before{};
        for (int i = 0; i < block.width; i += kPacketSize) {
            seeds.clear();
            for (int k = 0; k < kPacketSize; ++k) {
                addSeed(before[static_cast<std::size_t>(k)], seeds);
                addSeed(above[static_cast<std::size_t>(i + k)], seeds);
            }
            search.find(packetAt(block, i, j), seeds, found);
            for (int k = 0; k < kPacketSize; ++k) {
                before[static_cast<std::size_t>(k)] = found.place[apexOf(kPacketSize - 1, k)];
                above[static_cast<std::size_t>(i + k)] = found.place[apexOf(k, kPacketSize - 1)];
                for (int column = 0; column < kPacketSize; ++column)
                    slopes[blockIndex(i + column, j + k)] = found.slope[apexOf(column, k)];
            }
        }
    }
}

}  // namespace relievo::preprocess
