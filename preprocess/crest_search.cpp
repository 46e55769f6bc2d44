#include "preprocess/crest_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "preprocess/packet_search.h"
#include "preprocess/processor.h"

#define RELIEVO_KERNEL "preprocess/crest_search_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {
namespace {

using Packet = CrestSearch::Packet;
using Place = CrestSearch::Place;

// Copies beside each other along the shorter side of a tile: enough for 16 : 1 and four tiles.
constexpr int kMostCopies = 64;

// At the border of what is wanted the last column and row stand in for those that are missing.
// `limit`: the slope over the whole depth of one texel width that is known anyway.
Packet packetAt(const CrestBlock& block, int i, int j, float leastDepth, float reach) {
    const auto columnAt = [&](int k) { return std::min(i + k, block.width - 1); };
    const auto rowAt = [&](int k) { return std::min(j + k, block.height - 1); };
    Packet packet;
    for (int k = 0; k < kPacketSize; ++k) {
        packet.column[static_cast<std::size_t>(k)] = static_cast<float>(block.left + columnAt(k));
        packet.row[static_cast<std::size_t>(k)] = static_cast<float>(block.top + rowAt(k));
    }
    for (int row = 0; row < kPacketSize; ++row)
        for (int column = 0; column < kPacketSize; ++column) {
            const std::size_t from = blockIndex(columnAt(column), rowAt(row));
            const std::size_t to = packetIndex(column, row);
            float deepest = leastDepth;
            for (std::size_t k = 0; k < 4; ++k) {
                packet.depth[k][to] = block.depth[k][from];
                deepest = std::max(deepest, packet.depth[k][to]);
            }
            packet.known[to] = std::max(block.known[from], (deepest - leastDepth) / reach);
        }
    return packet;
}

int copiesAlong(double tileWidth, int texels, double tileLength, textures::WrapMode wrap) {
    if (wrap == textures::WrapMode::Clamp || texels == 1)
        return 0;
    return std::clamp(static_cast<int>(std::ceil(CrestSearch::kTiles * tileWidth / tileLength)), 1,
                      kMostCopies);
}

}  // namespace

CrestSearch::CrestSearch(const textures::DepthMap& map, const textures::Plane& depths,
                         const CrestTree& tree, CrestLeaves leaves, const ChordSector& sector)
    : scene_{&depths,
             &tree,
             static_cast<float>(map.texelAspect),
             map.wrap,
             map.width(),
             map.height(),
             copiesAlong(map.width(), map.width(), map.width(), map.wrap),
             copiesAlong(map.width(), map.height(), map.height() * map.texelAspect, map.wrap),
             sector},
      leaves_(leaves),
      reach_(std::numeric_limits<float>::infinity()) {
    if (scene_.copiesX > 0)
        reach_ = static_cast<float>(scene_.copiesX * map.width());
    if (scene_.copiesY > 0)
        reach_ =
            std::min(reach_, static_cast<float>(scene_.copiesY * map.height()) * scene_.aspect);
}

void CrestSearch::find(const CrestBlock& block, BlockValues& slopes) {
    searchInPackets<Found>(block.width, block.height, slopes,
                           [&](int i, int j, const std::vector<Place>& seeds, Found& found) {
                               ++statistics_.packets;
                               const Packet packet =
                                   packetAt(block, i, j, scene_.tree->leastDepth, reach_);
                               if (leaves_ == CrestLeaves::Texels)
                                   RELIEVO_CALL_KERNEL(findTexelCrests, scene_, stack_, statistics_,
                                                       packet, seeds, found);
                               else
                                   RELIEVO_CALL_KERNEL(findCellCrests, scene_, stack_, statistics_,
                                                       packet, seeds, found);
                           });
}

}  // namespace relievo::preprocess
