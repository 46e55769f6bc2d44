#pragma once

#include <span>
#include <string_view>

#include "materials/relief_maps.h"

namespace relievo::materials {

/// Where the slopes come from that shade a relief, and that some searches follow. Each gives the
/// same normals at every depth scale, up to what the map's texels resolve.
enum class SlopeSource {
    Derivative,  ///< the map of derivatives: one lookup
    Normal,      ///< stored unit normals, rescaled from the depth scale they are for: one lookup
    Height,      ///< finite differences of the depths: four lookups, and no further map
};

/// How a source is called and reached.
struct SlopeSourceEntry {
    SlopeSource source;
    std::string_view name;    ///< on command lines
    std::string_view title;   ///< one line for --help and panels
    std::string_view origin;  ///< author and year
    std::string_view map;     ///< the map that it reads (relief_maps.h), or empty
    std::string_view define;  ///< of shaders/relievo/slopes.glsl, or empty
};

/// All sources, the best first.
std::span<const SlopeSourceEntry> slopeSources();

const SlopeSourceEntry& slopeSourceEntry(SlopeSource source);

/// The first of slopeSources() whose map `maps` has.
SlopeSource bestSlopeSource(const ReliefMaps& maps);

}  // namespace relievo::materials
