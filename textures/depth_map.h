#pragma once

#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::textures {

/// A relief: depth samples D in [0,1], 0 on the reference surface and 1 at the bottom, and the way
/// it continues outside its tile. The surface is their bilinear interpolation between texel
/// centres.
///
/// Metric: horizontal lengths are in tile widths, a texel is 1/width wide and texelAspect/width
/// high, and |(du,dv)|² = du² + ρ²·dv² with ρ = texelAspect·height/width, the height of the tile.
/// Texels are square except in mip levels of odd sizes, which cover the same tile with fewer rows
/// or columns than half.
struct DepthMap {
    Plane depth;
    WrapMode wrap = WrapMode::Repeat;
    double texelAspect = 1.0;  ///< height of a texel over its width, > 0

    [[nodiscard]] int width() const noexcept { return depth.width; }
    [[nodiscard]] int height() const noexcept { return depth.height; }
    /// ρ: height of the tile over its width.
    [[nodiscard]] double aspect() const noexcept {
        return texelAspect * static_cast<double>(depth.height) / static_cast<double>(depth.width);
    }
    /// D of texel (i,j) for any integers i and j, under the wrap mode.
    [[nodiscard]] float at(std::int64_t i, std::int64_t j) const noexcept {
        return depth.at(wrapIndex(i, depth.width, wrap), wrapIndex(j, depth.height, wrap));
    }
};

}  // namespace relievo::textures
