#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "textures/depth_map.h"
#include "textures/sample_surface.h"

namespace relievo::textures {

/// A colour with sRGB components in [0,1].
struct SampleColour {
    double red;
    double green;
    double blue;
};

/// A generated relief: deterministic in (width, height, seed) and periodic in both directions.
struct SampleRelief {
    std::string_view name;
    std::string_view description;
    SampleFunction surface;
    // The colours of the albedo that goes with it.
    SampleColour feature;
    SampleColour ground;
    double variety;  ///< how much the lightness of stones, letters … differs
};

/// noise, cobbles, bricks, blocks, pillars, spikes, ridge, hemispheres, wave, lettering.
std::span<const SampleRelief> sampleReliefs();

/// The relief called `name`. Throws InputError, listing the names, for an unknown one.
const SampleRelief& findSampleRelief(std::string_view name);

/// Generates the relief called `name`. The same arguments give the same samples on every machine.
/// Throws InputError, listing the names, for an unknown one, or for a size below 1.
DepthMap generateSampleRelief(std::string_view name, int width, int height, std::uint32_t seed = 1);

/// Depth of the relief `wave` at any (u,v): ½ + 0.24·sin 2π(u+2v) + 0.24·cos 2π(2u−v).
double waveDepth(double u, double v);

}  // namespace relievo::textures
