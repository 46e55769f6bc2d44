#include "preprocess/slope_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "preprocess/processor.h"

#define RELIEVO_KERNEL "preprocess/slope_search_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {
namespace {

using textures::WrapMode;

// The copies along one axis in which the chords of a sector end, as numbers of tiles from the tile
// itself. Ahead, every depth is met within one tile; in half a quadrant only after the chord has
// gone as far along this axis as it went along the other.
std::vector<int> tilesAlong(float sign, bool leads, float length, float otherLength) {
    const int farthest = leads ? 2 + static_cast<int>(std::ceil(otherLength / length)) : 1;
    std::vector<int> tiles = {0};
    for (int k = 1; k <= farthest; ++k)
        if (sign != 0.0f)
            tiles.push_back(sign > 0.0f ? k : -k);
    // The last cell of the tile ends in the next tile.
    if (sign < 0.0f)
        tiles.push_back(1);
    if (sign == 0.0f)
        tiles = {-1, 0, 1};
    return tiles;
}

std::vector<TileCopy> copiesFor(const SlopeSearchSpace& space, const ChordSector& sector) {
    const bool hasSector = sector.signX != 0.0f || sector.signY != 0.0f;
    if (space.wrap == WrapMode::Clamp || (space.wrap == WrapMode::Mirror && !hasSector))
        return {TileCopy{}};
    const bool flips = space.wrap == WrapMode::Mirror;
    const auto width = static_cast<float>(space.tree.width);
    const float height = static_cast<float>(space.tree.height) * space.aspect;
    std::vector<TileCopy> copies;
    for (const int b :
         tilesAlong(sector.signY, sector.half == ChordSector::Half::Steep, height, width))
        for (const int a :
             tilesAlong(sector.signX, sector.half == ChordSector::Half::Shallow, width, height))
            copies.push_back({a * space.tree.width, b * space.tree.height, flips && a % 2 != 0,
                              flips && b % 2 != 0});
    return copies;
}

}  // namespace

ChordSector chordSector(int number, int sectors) noexcept {
    ChordSector sector;
    if (sectors == 1)
        return sector;
    sector.signX = number % 2 == 0 ? 1.0f : -1.0f;
    sector.signY = number / 2 % 2 == 0 ? 1.0f : -1.0f;
    if (sectors == 8)
        sector.half = number >= 4 ? ChordSector::Half::Steep : ChordSector::Half::Shallow;
    return sector;
}

bool ChordSector::counts(double fromX, double fromY, double halfSide,
                         double halfHeight) const noexcept {
    // The samples at the near corners of the cell count.
    const double alongX = fromX * signX;
    const double alongY = fromY * signY;
    if (alongX < -1.5 * halfSide || alongY < -1.5 * halfHeight)
        return false;
    if (half == Half::Shallow)
        return alongY <= alongX + slack;
    return half == Half::Both || alongX <= alongY + slack;
}

SlopeSearchStatistics& SlopeSearchStatistics::operator+=(
    const SlopeSearchStatistics& other) noexcept {
    packets += other.packets;
    nodes += other.nodes;
    samples += other.samples;
    return *this;
}

SlopeSearch::SlopeSearch(const ReliefTree& tree, textures::WrapMode wrap, double aspect,
                         const SlopeSearchRules& rules)
    : space_{tree, wrap, static_cast<float>(aspect), {}}, rules_(rules) {
    if (wrap == WrapMode::Clamp)
        rules_.sector.half = ChordSector::Half::Both;
    space_.copies = copiesFor(space_, rules_.sector);
}

void SlopeSearch::find(const SlopePacket& packet, std::span<const SamplePlace> seeds,
                       PacketSlopes& found) {
    ++statistics_.packets;
    RELIEVO_CALL_KERNEL(findPacketSlopes, space_, rules_, packet, seeds, stack_, statistics_,
                        found);
}

}  // namespace relievo::preprocess
