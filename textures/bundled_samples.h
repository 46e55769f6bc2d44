#pragma once

#include <array>
#include <string_view>

namespace relievo::textures {

/// A sample relief that the project carries as pictures in `textures/samples`, square.
struct BundledSample {
    std::string_view name;
    int size;
};

inline constexpr std::array kBundledSamples{
    BundledSample{"bricks", 384}, BundledSample{"cobbles", 384}, BundledSample{"lettering", 384},
    BundledSample{"noise", 256}};

}  // namespace relievo::textures
