#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "textures/depth_map.h"

namespace relievo::textures {

/// A generated relief: deterministic in (width, height, seed) and periodic in both directions.
struct SampleRelief {
    std::string_view name;
    std::string_view description;
};

/// noise, cobbles, bricks, blocks, pillars, spikes, ridge, hemispheres, wave, lettering.
std::span<const SampleRelief> sampleReliefs();

/// Generates the relief called `name`. The same arguments give the same samples on every machine.
/// Throws InputError, listing the names, for an unknown one, or for a size below 1.
DepthMap generateSampleRelief(std::string_view name, int width, int height, std::uint32_t seed = 1);

}  // namespace relievo::textures
