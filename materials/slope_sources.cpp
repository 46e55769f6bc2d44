#include "materials/slope_sources.h"

#include <algorithm>
#include <cassert>

namespace relievo::materials {
namespace {

// Derivatives come before normals, which have lost what their number format and the filter between
// texels take from a direction; differences of depths lose nothing, but cost four lookups.
constexpr SlopeSourceEntry kSources[] = {
    {.source = SlopeSource::Derivative,
     .name = "derivative",
     .title = "map of derivatives",
     .origin = "thesis 1.6",
     .map = "derivative",
     .define = ""},
    {.source = SlopeSource::Normal,
     .name = "normal",
     .title = "stored normals, rescaled",
     .origin = "Peercy, Airey, Cabral 1997; thesis 1.6",
     .map = "normal",
     .define = "RELIEVO_SLOPES_FROM_NORMAL"},
    {.source = SlopeSource::Height,
     .name = "height",
     .title = "differences of depths",
     .origin = "Blinn 1978",
     .map = "",
     .define = "RELIEVO_SLOPES_FROM_HEIGHT"},
};

}  // namespace

std::span<const SlopeSourceEntry> slopeSources() {
    return kSources;
}

const SlopeSourceEntry& slopeSourceEntry(SlopeSource source) {
    const auto found = std::ranges::find(kSources, source, &SlopeSourceEntry::source);
    assert(found != std::end(kSources));
    return *found;
}

SlopeSource bestSlopeSource(const ReliefMaps& maps) {
    const auto found = std::ranges::find_if(kSources, [&](const SlopeSourceEntry& entry) {
        return entry.map.empty() || maps.has(entry.map);
    });
    return found->source;
}

}  // namespace relievo::materials
