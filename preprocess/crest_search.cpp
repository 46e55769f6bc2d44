#include "preprocess/crest_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "preprocess/processor.h"

#define RELIEVO_KERNEL "preprocess/crest_search_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {
namespace {

using Packet = CrestSearch::Packet;
using Place = CrestSearch::Place;

constexpr int kCrestPacketSize = 4;
static_assert(kCrestPacketSize * kCrestPacketSize == kLanes && kBlockSize % kCrestPacketSize == 0);
// Copies beside each other along the shorter side of a tile: enough for 16 : 1 and four tiles.
constexpr int kMostCopies = 64;

constexpr std::size_t laneOf(int column, int row) {
    return static_cast<std::size_t>(row * kCrestPacketSize + column);
}

// At the border of what is wanted the last column and row stand in for those that are missing.
// `limit`: the slope over the whole depth of one texel width that is known anyway.
Packet packetAt(const CrestBlock& block, int i, int j, float leastDepth, float reach) {
    Packet packet;
    for (int row = 0; row < kCrestPacketSize; ++row)
        for (int column = 0; column < kCrestPacketSize; ++column) {
            const int x = std::min(i + column, block.width - 1);
            const int y = std::min(j + row, block.height - 1);
            const std::size_t lane = laneOf(column, row);
            packet.column[lane] = static_cast<float>(block.left + x);
            packet.row[lane] = static_cast<float>(block.top + y);
            float deepest = leastDepth;
            for (std::size_t k = 0; k < 4; ++k) {
                packet.depth[k][lane] = block.depth[k][blockIndex(x, y)];
                deepest = std::max(deepest, packet.depth[k][lane]);
            }
            packet.known[lane] =
                std::max(block.known[blockIndex(x, y)], (deepest - leastDepth) / reach);
        }
    return packet;
}

void addSeed(const Place& place, std::vector<Place>& seeds) {
    if (place.i >= 0 && std::find(seeds.begin(), seeds.end(), place) == seeds.end())
        seeds.push_back(place);
}

int copiesAlong(double tileWidth, int texels, double tileLength, textures::WrapMode wrap) {
    if (wrap == textures::WrapMode::Clamp || texels == 1)
        return 0;
    return std::clamp(static_cast<int>(std::ceil(CrestSearch::kTiles * tileWidth / tileLength)), 1,
                      kMostCopies);
}

}  // namespace

CrestSearch::CrestSearch(const textures::DepthMap& map, const textures::Plane& depths,
                         const CrestTree& tree, CrestLeaves leaves)
    : scene_{&depths,
             &tree,
             static_cast<float>(map.texelAspect),
             map.wrap,
             map.width(),
             map.height(),
             copiesAlong(map.width(), map.width(), map.width(), map.wrap),
             copiesAlong(map.width(), map.height(), map.height() * map.texelAspect, map.wrap)},
      leaves_(leaves),
      reach_(std::numeric_limits<float>::infinity()) {
    if (scene_.copiesX > 0)
        reach_ = static_cast<float>(scene_.copiesX * map.width());
    if (scene_.copiesY > 0)
        reach_ =
            std::min(reach_, static_cast<float>(scene_.copiesY * map.height()) * scene_.aspect);
}

void CrestSearch::find(const CrestBlock& block, BlockValues& slopes) {
    std::array<Place, kBlockSize> above{};
    std::vector<Place> seeds;
    Found found;
    for (int j = 0; j < block.height; j += kCrestPacketSize) {
        std::array<Place, kCrestPacketSize> before{};
        for (int i = 0; i < block.width; i += kCrestPacketSize) {
            seeds.clear();
            for (int k = 0; k < kCrestPacketSize; ++k) {
                addSeed(before[static_cast<std::size_t>(k)], seeds);
                addSeed(above[static_cast<std::size_t>(i + k)], seeds);
            }
            ++statistics_.packets;
            const Packet packet = packetAt(block, i, j, scene_.tree->leastDepth, reach_);
            if (leaves_ == CrestLeaves::Texels)
                RELIEVO_CALL_KERNEL(findTexelCrests, scene_, stack_, statistics_, packet, seeds,
                                    found);
            else
                RELIEVO_CALL_KERNEL(findCellCrests, scene_, stack_, statistics_, packet, seeds,
                                    found);
            for (int k = 0; k < kCrestPacketSize; ++k) {
                before[static_cast<std::size_t>(k)] = found.place[laneOf(kCrestPacketSize - 1, k)];
                above[static_cast<std::size_t>(i + k)] =
                    found.place[laneOf(k, kCrestPacketSize - 1)];
                for (int column = 0; column < kCrestPacketSize; ++column)
                    slopes[blockIndex(i + column, j + k)] = found.slope[laneOf(column, k)];
            }
        }
    }
}

}  // namespace relievo::preprocess
