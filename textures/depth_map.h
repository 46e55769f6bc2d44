#pragma once

#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::textures {

/// A relief: depth samples D in [0,1], 0 on the reference surface and 1 at the bottom, and the way
/// it continues outside its tile. The surface is their bilinear interpolation between texel
/// centres.
///
/// Metric: horizontal lengths are in tile widths and texels are square, so a texel is 1/width wide
/// and high, and |(du,dv)|² = du² + ρ²·dv² with ρ = height/width.
struct DepthMap {
    Plane depth;
    WrapMode wrap = WrapMode::Repeat;

    [[nodiscard]] int width() const noexcept { return depth.width; }
    [[nodiscard]] int height() const noexcept { return depth.height; }
    /// ρ = height/width.
    [[nodiscard]] double aspect() const noexcept {
        return static_cast<double>(depth.height) / static_cast<double>(depth.width);
    }
    /// D of texel (i,j) for any integers i and j, under the wrap mode.
    [[nodiscard]] float at(std::int64_t i, std::int64_t j) const noexcept {
        return depth.at(wrapIndex(i, depth.width, wrap), wrapIndex(j, depth.height, wrap));
    }
};

}  // namespace relievo::textures
