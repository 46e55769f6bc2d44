#pragma once

#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::textures {

struct MapSet;

/// A plane shape by the distances to its outline, and the way it continues outside its tile. The
/// distance anywhere is the bilinear interpolation of the samples at texel centres, d(u,v); solids
/// are made of the points where d is at most an offset (specification 7.2).
///
/// Lengths are in tile widths: texels are square, 1/width wide and high, and
/// |(du,dv)|² = du² + ρ²·dv² with ρ = height/width.
struct ShapeMap {
    /// Outside > 0. Inside < 0 in a signed map, 0 in an unsigned one (as in the thesis).
    Plane distance;
    /// The direction in which the distance grows, of unit length in the metric: ∂d/∂(u, ρ·v).
    Plane gradientX;
    Plane gradientY;
    Plane shape;  ///< how much of each texel is inside, in [0,1]
    WrapMode wrap = WrapMode::Repeat;
    bool isSigned = true;
    /// By how much stored distances are nearer to 0 than true ones, at most (tile widths, ≥ 0):
    /// what rounding to the file's format has taken. A safe step takes it off.
    double slack = 0.0;

    [[nodiscard]] int width() const noexcept { return distance.width; }
    [[nodiscard]] int height() const noexcept { return distance.height; }
    /// ρ: height of the tile over its width.
    [[nodiscard]] double aspect() const noexcept {
        return static_cast<double>(distance.height) / static_cast<double>(distance.width);
    }
    /// The distance of texel (i,j) for any integers i and j, under the wrap mode.
    [[nodiscard]] float at(std::int64_t i, std::int64_t j) const noexcept {
        return distance.at(wrapIndex(i, distance.width, wrap), wrapIndex(j, distance.height, wrap));
    }
};

/// The shape that a map set of the kind `shape` describes: channels `distance`, `gx`, `gy` and
/// `shape`, attributes `relievo:signed` ("0" or "1") and `relievo:slack`. Throws InputError that
/// names the channel or attribute which is missing or senseless.
ShapeMap shapeMapOf(const MapSet& maps);

/// The inverse: the map set of a shape.
MapSet mapSetOf(const ShapeMap& shape);

}  // namespace relievo::textures
