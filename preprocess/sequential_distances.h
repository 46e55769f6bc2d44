#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "preprocess/distance_transform.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// Distances by the four-point sequential method (4SED; Danielsson 1980, as algorithm 3.4 of the
/// thesis): each texel takes over the nearest texel of the set from its four neighbours, in one
/// sweep down and one up, both with a sweep of each row to the right and to the left. A baseline
/// for distancesTo, which has the same arguments: some texels learn of their nearest one from no
/// neighbour and get a distance that is too large, never one that is too small. That is unsafe for
/// all that steps by distances.
///
/// Repeat goes once and a half around the tile instead of building a larger one.
SquaredDistances sequentialDistances(std::span<const std::uint8_t> set, int width, int height,
                                     textures::WrapMode wrap);

/// How far measured distances are from exact ones.
struct DistanceErrors {
    std::size_t tooLarge = 0;  ///< texels with a larger distance than the exact one
    std::size_t tooSmall = 0;  ///< texels with a smaller one
    double greatest = 0.0;     ///< greatest difference of distances, in texels
};

/// Compares distances of the same set and size.
DistanceErrors compareDistances(const SquaredDistances& measured, const SquaredDistances& exact);

}  // namespace relievo::preprocess
