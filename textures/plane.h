#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include "textures/large_pages.h"

namespace relievo::textures {

/// One channel of an image: width × height samples, row by row, row 0 at the top of the picture.
///
/// Orientation, stated here for the whole project: texel (i,j) has its centre at
/// u = (i+½)/width, v = (j+½)/height, so the origin of (u,v) is the top left corner of the picture
/// and v grows downwards, in files, in memory and on the GPU (row 0 is uploaded first).
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> texels;

    Plane() = default;
    Plane(int width_, int height_, float value = 0.0f) : width(width_), height(height_) {
        assert(width_ >= 0 && height_ >= 0);
        const auto count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        reserveLargePages(texels, count);
        texels.resize(count, value);
    }

    [[nodiscard]] std::size_t index(int i, int j) const noexcept {
        assert(i >= 0 && i < width && j >= 0 && j < height);
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(i);
    }
    [[nodiscard]] float at(int i, int j) const noexcept { return texels[index(i, j)]; }
    [[nodiscard]] float& at(int i, int j) noexcept { return texels[index(i, j)]; }
};

}  // namespace relievo::textures
