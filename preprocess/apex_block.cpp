#include "preprocess/apex_block.h"

#include <algorithm>
#include <vector>

#include "preprocess/packet_search.h"

namespace relievo::preprocess {
namespace {

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
            packet.depth[packetIndex(column, row)] = block.depth[from];
            packet.known[packetIndex(column, row)] = block.known[from];
        }
    return packet;
}

}  // namespace

void findSlopes(SlopeSearch& search, const ApexBlock& block, BlockValues& slopes) {
    searchInPackets<PacketSlopes>(
        block.width, block.height, slopes,
        [&](int i, int j, const std::vector<SamplePlace>& seeds, PacketSlopes& found) {
            search.find(packetAt(block, i, j), seeds, found);
        });
}

}  // namespace relievo::preprocess
