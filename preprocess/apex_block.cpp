#include "preprocess/apex_block.h"

#include <algorithm>
#include <vector>

namespace relievo::preprocess {
namespace {

constexpr int kPacketSize = 4;
static_assert(kPacketSize * kPacketSize == kLanes && kBlockSize % kPacketSize == 0);

constexpr std::size_t laneOf(int column, int row) {
    return static_cast<std::size_t>(row * kPacketSize + column);
}

// The packet whose first apex is (i,j) of the block. At the border of what is wanted the last
// column and row stand in for those that are missing.
SlopePacket packetAt(const ApexBlock& block, int i, int j) {
    SlopePacket packet;
    for (int row = 0; row < kPacketSize; ++row)
        for (int column = 0; column < kPacketSize; ++column) {
            const int x = std::min(i + column, block.width - 1);
            const int y = std::min(j + row, block.height - 1);
            const std::size_t lane = laneOf(column, row);
            packet.column[lane] = block.left + static_cast<float>(x);
            packet.row[lane] = block.top + static_cast<float>(y);
            packet.depth[lane] = block.depth[blockIndex(x, y)];
            packet.known[lane] = block.known[blockIndex(x, y)];
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
                before[static_cast<std::size_t>(k)] = found.place[laneOf(kPacketSize - 1, k)];
                above[static_cast<std::size_t>(i + k)] = found.place[laneOf(k, kPacketSize - 1)];
                for (int column = 0; column < kPacketSize; ++column)
                    slopes[blockIndex(i + column, j + k)] = found.slope[laneOf(column, k)];
            }
        }
    }
}

}  // namespace relievo::preprocess
