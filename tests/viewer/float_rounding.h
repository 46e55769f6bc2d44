#pragma once

#include "reference/bilinear_tracer.h"
#include "textures/depth_map.h"
#include "viewer/measured_frame.h"

namespace relievo::viewer {

/// What the rounding of floats may do to the hits of a search that walks from cell to cell and
/// solves them (shaders/relievo/search/cells.glsl), and nothing else.
class FloatRounding {
  public:
    /// The map must be there as long.
    explicit FloatRounding(const textures::DepthMap& map);

    /// Whether a hit is not before the one on a relief that is higher by the rounding, nor after
    /// the one on a relief that is lower by it; whether a miss misses the lower one. Near a tangent
    /// that may be a long way; elsewhere it is nothing that can be seen. A search that ran out of
    /// steps is not explained. The relief has no window.
    [[nodiscard]] bool explains(const MeasuredPixel& pixel) const;

  private:
    // Where a ray first meets the relief when all of it lies `lower` deeper; infinity when it does
    // not.
    [[nodiscard]] double meets(reference::TileRay ray, double lower) const;

    const textures::DepthMap& map_;
    double steepest_;  // step from a texel to one of its neighbours
};

}  // namespace relievo::viewer
