#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// For each texel of a tile, row by row, whether its centre is inside a shape: 1 or 0. Kept in step
/// with an outline that is changed.
struct TexelSides {
    int width = 0;
    int height = 0;
    textures::WrapMode wrap = textures::WrapMode::Repeat;
    std::vector<std::uint8_t> inside;

    /// Those that are covered by at least a half.
    TexelSides(const textures::Plane& coverage, textures::WrapMode wrap_);

    /// The centres within a loop (texels) change sides: an outline went around one side of it and
    /// now goes around the other. Under repeat loops may leave the tile.
    void flipWithin(std::span<const glm::dvec2> loop);
};

}  // namespace relievo::preprocess
