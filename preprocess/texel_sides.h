#pragma once

#include <cstddef>
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

    /// Of texel (i,j), for any integers i and j under the wrap mode.
    [[nodiscard]] bool isInside(int i, int j) const noexcept { return inside[index(i, j)] != 0; }

    /// Appends the numbers of the texels whose centres are within a loop (texels): an outline went
    /// around one side of them and now goes around the other. Under repeat loops may leave the
    /// tile.
    void appendWithin(std::span<const glm::dvec2> loop, std::vector<std::size_t>& texels) const;

    /// These texels change sides, as often as they are named.
    void flip(std::span<const std::size_t> texels);

  private:
    [[nodiscard]] std::size_t index(int i, int j) const noexcept {
        return static_cast<std::size_t>(textures::wrapIndex(j, height, wrap)) *
                   static_cast<std::size_t>(width) +
               static_cast<std::size_t>(textures::wrapIndex(i, width, wrap));
    }
};

}  // namespace relievo::preprocess
