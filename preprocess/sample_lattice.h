#pragma once

#include <cstddef>
#include <vector>

#include "textures/depth_map.h"

namespace relievo::preprocess {

/// The bilinear surface over a square block of texels and a border around it, sampled
/// `subdivisions` times per texel in both directions. Samples with the same place within their
/// texel lie together, row by row, so that the samples of sixteen texels beside each other are
/// sixteen floats beside each other, and the step from any sample to any other one is the same
/// number for all texels.
class SampleLattice {
  public:
    SampleLattice(int subdivisions, int blockSize, int border);

    /// Samples the block of `map` whose first texel is (left,top); its border, and what the map
    /// does not have, follow the wrap mode.
    void fill(const textures::DepthMap& map, int left, int top);

    [[nodiscard]] int subdivisions() const noexcept { return subdivisions_; }
    /// The sample at the centre of texel (i,j) of the block, from −border to blockSize + border
    /// − 1.
    [[nodiscard]] const float* texel(int i, int j) const noexcept {
        return samples_.data() + stepTo(i * subdivisions_, j * subdivisions_) + origin_;
    }
    /// The step from the centre of a texel to the sample that is (x,y) subdivisions away.
    [[nodiscard]] std::ptrdiff_t stepTo(int x, int y) const noexcept;

  private:
    int subdivisions_;
    int border_;
    int side_;  // of the planes: block, borders, and one texel more to interpolate from
    std::ptrdiff_t origin_;
    std::vector<float> samples_;
};

}  // namespace relievo::preprocess
