#pragma once

#include "textures/shape_map.h"

namespace relievo::solids {

/// How far from a place the bilinear distance of a map keeps clear of a range of offsets.
///
/// The bilinear interpolation at p is the mean of the samples at p rounded at random to one of the
/// four texels around it. Rounding p and q by the same random numbers brings them √(r² + ½) apart
/// at most in the mean, r = |p − q| in texels. Samples of a distance differ by no more than their
/// places do, so d changes by at most min(√2·r, √(r² + ½)) + slack. Of a map that is no distance
/// neighbours differ by λ texels, and d changes by at most √2·λ·r.
class FreeSpace {
  public:
    /// `isDistance`: the samples are distances as their map's wrap mode has them, nearer to 0 by at
    /// most its slack. Where neighbours differ by more than a texel they can not be, and the claim
    /// is not believed. `wrap`: how the map is read.
    FreeSpace(const textures::ShapeMap& map, textures::WrapMode wrap, bool isDistance);

    /// By how much d changes at least within `texels` of a place; the inverse of `reach`.
    [[nodiscard]] double change(double texels) const noexcept;
    /// The radius, in texels, within which d changes by less than `lengths` tile widths; 0 for
    /// lengths ≤ 0.
    [[nodiscard]] double reach(double lengths) const noexcept;
    /// The radius in texels within which d is not in [low, high], when it is `distance` here; 0
    /// when that is in it.
    [[nodiscard]] double radius(double distance, double low, double high) const noexcept;

    /// Tile widths that `reach` does not count on: what rounding has taken from the samples near
    /// a place of that distance.
    [[nodiscard]] double uncertainty(double distance) const noexcept;
    [[nodiscard]] bool isDistance() const noexcept { return isDistance_; }
    /// The largest change of d per texel, in texels.
    [[nodiscard]] double steepest() const noexcept { return steepest_; }
    [[nodiscard]] double texels() const noexcept { return texels_; }

  private:
    double texels_;  // in a tile width
    double slack_;   // tile widths
    double steepest_ = 0.0;
    bool isDistance_ = false;
};

}  // namespace relievo::solids
