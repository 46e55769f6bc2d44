#include "preprocess/slope_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "preprocess/processor.h"

#define RELIEVO_KERNEL "preprocess/slope_search_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {

SlopeSearchStatistics& SlopeSearchStatistics::operator+=(
    const SlopeSearchStatistics& other) noexcept {
    packets += other.packets;
    nodes += other.nodes;
    samples += other.samples;
    return *this;
}

SlopeSearch::SlopeSearch(const ReliefTree& tree, textures::WrapMode wrap, double aspect,
                         const SlopeSearchRules& rules)
    : tree_(tree),
      repeats_(wrap == textures::WrapMode::Repeat),
      aspect_(static_cast<float>(aspect)),
      rules_(rules) {}

void SlopeSearch::find(const SlopePacket& packet, std::span<const SamplePlace> seeds,
                       PacketSlopes& found) {
    ++statistics_.packets;
    RELIEVO_CALL_KERNEL(findPacketSlopes, {tree_, repeats_, aspect_, rules_, stack_, statistics_},
                        packet, seeds, found);
}

}  // namespace relievo::preprocess
