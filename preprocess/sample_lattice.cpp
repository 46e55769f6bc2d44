#include "preprocess/sample_lattice.h"

namespace relievo::preprocess {
namespace {

std::ptrdiff_t floorDivide(std::ptrdiff_t a, std::ptrdiff_t b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

}  // namespace

SampleLattice::SampleLattice(int subdivisions, int blockSize, int border)
    : subdivisions_(subdivisions),
      border_(border),
      side_(blockSize + 2 * border + 1),
      origin_(static_cast<std::ptrdiff_t>(border) * (side_ + 1)),
      samples_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) *
               static_cast<std::size_t>(subdivisions * subdivisions)) {}

std::ptrdiff_t SampleLattice::stepTo(int x, int y) const noexcept {
    const std::ptrdiff_t i = floorDivide(x, subdivisions_);
    const std::ptrdiff_t j = floorDivide(y, subdivisions_);
    const std::ptrdiff_t plane = (y - j * subdivisions_) * subdivisions_ + (x - i * subdivisions_);
    return (plane * side_ + j) * side_ + i;
}

void SampleLattice::fill(const textures::DepthMap& map, int left, int top) {
    const auto side = static_cast<std::size_t>(side_);
    for (int row = 0; row < side_; ++row) {
        const int j = textures::wrapIndex(top - border_ + row, map.height(), map.wrap);
        float* const to = samples_.data() + static_cast<std::size_t>(row) * side;
        for (int column = 0; column < side_; ++column)
            to[column] = map.depth.at(
                textures::wrapIndex(left - border_ + column, map.width(), map.wrap), j);
    }
    const float step = 1.0f / static_cast<float>(subdivisions_);
    for (int plane = 1; plane < subdivisions_ * subdivisions_; ++plane) {
        const float x = static_cast<float>(plane % subdivisions_) * step;
        const float y = static_cast<float>(plane / subdivisions_) * step;
        float* const to = samples_.data() + static_cast<std::size_t>(plane) * side * side;
        for (std::size_t row = 0; row + 1 < side; ++row) {
            const float* const above = samples_.data() + row * side;
            const float* const below = above + side;
            for (std::size_t k = 0; k + 1 < side; ++k) {
                const float aboveHere = above[k] + (above[k + 1] - above[k]) * x;
                const float belowHere = below[k] + (below[k + 1] - below[k]) * x;
                to[row * side + k] = aboveHere + (belowHere - aboveHere) * y;
            }
        }
    }
}

}  // namespace relievo::preprocess
