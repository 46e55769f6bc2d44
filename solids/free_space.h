#pragma once

#include <array>

#include "textures/shape_map.h"

namespace relievo::solids {

/// Where d is clear of a value by c texels here, it is clear of it within the radius r texels:
/// r² = factor·max(0, c − uncertainty)² − less, where that is positive.
struct ReachTerm {
    double factor = 0.0;
    double less = 0.0;
    double uncertainty = 0.0;
};

/// How far from a place the distance of a map keeps clear of an offset: as far as the farthest of
/// three bounds of d, the interpolation of ShapeMap::steps(). Where there are creases the distance
/// itself is nowhere below d, and above it by at most creaseDepth.
///
/// Neighbouring texels differ by λ texels at most; that is measured, of whatever a map holds. Then
/// d changes by no more than √2·λ per texel. Samples of a distance differ by no more than their
/// places do, which says more from afar: the bilinear interpolation at p is the mean of the samples
/// at p rounded at random to one of the four texels around it, and rounding p and q by the same
/// random numbers brings them √(r² + ½) apart at most in the mean, r = |p − q| in texels. So d
/// changes by at most min(√2·r, √(r² + ½)) and what rounding has taken from the samples.
class FreeSpace {
  public:
    /// `isDistance`: the samples are distances as `wrap` continues them, nearer to 0 by at most the
    /// map's slack. Where neighbours differ by more than a texel they can not be, and the claim is
    /// not believed. `wrap`: how the map is read.
    FreeSpace(const textures::ShapeMap& map, textures::WrapMode wrap, bool isDistance);

    /// The bounds near a place where d is `distance` (tile widths).
    [[nodiscard]] std::array<ReachTerm, 3> terms(double distance) const noexcept;
    /// The radius in texels within which the distance of the map is not in [low, high], where d is
    /// `distance` in the middle; 0 when that cannot be told. All in tile widths.
    [[nodiscard]] double radius(double distance, double low, double high) const noexcept;

    /// How long d keeps clear of an offset that it is clear of by `clear` tile widths here, where d
    /// is `distance`, and that comes nearer by `closing` per unit of a parameter (one that goes
    /// away is taken to stay) while the place moves by `speed` ≥ 0 texels.
    [[nodiscard]] double duration(double distance, double clear, double closing,
                                  double speed) const noexcept;

    /// How far a distance may be above d, in tile widths.
    [[nodiscard]] double creaseDepth() const noexcept { return creaseDepth_; }
    [[nodiscard]] bool isDistance() const noexcept { return isDistance_; }
    /// Of a tile width.
    [[nodiscard]] double texels() const noexcept { return texels_; }

  private:
    double texels_;
    double slack_;  // texels
    double creaseDepth_;
    double measuredFactor_ = 0.0;
    bool isDistance_ = false;
};

}  // namespace relievo::solids
