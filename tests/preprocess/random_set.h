#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace relievo::preprocess {

/// A set of texels, one byte each, with about one texel in `oneIn`: the same on every machine.
inline std::vector<std::uint8_t> randomSet(int width, int height, unsigned oneIn,
                                           std::uint32_t seed) {
    std::mt19937 generator(seed);
    std::vector<std::uint8_t> set(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
    std::generate(set.begin(), set.end(),
                  [&] { return generator() % oneIn == 0 ? std::uint8_t{1} : std::uint8_t{0}; });
    return set;
}

}  // namespace relievo::preprocess
