#pragma once

#include <cmath>
#include <cstddef>

#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::textures {

struct MapSet;

/// What the code of a reflex crease has more than that of a convex one, in texels.
inline constexpr double kReflexTexels = 16.0;
/// From what code on a crease is a reflex one, in texels: less, as number formats round it.
inline constexpr double kLeastReflexTexels = 12.0;

/// The offset at which corners end: more than the diagonal of a texel deeper, convex creases are
/// inside of the solid, and so are all samples that differ from true distances for the sake of a
/// corner. From there on steps may go by the distance (reference::safeStep).
inline constexpr double kCornersEndTexels = 4.0;

/// What keeps the corners of a shape sharp: no bilinear distance has a corner. Around one, the
/// distance is the larger (convex corner) or smaller (reflex corner) one of two bilinear fields, A
/// and B, the distances to both sides of the corner; each sample is that of one side, and its code
/// c says where the other one is, in tile widths, with R = kReflexTexels texels:
///
///   c = −|A − B| or −(R + |A − B|): the sample's distance is A's, at a convex or a reflex corner;
///   c = +|A − B| or +(R + |A − B|): it is B's;
///   c = 0: A and B are the same.
///
/// A cell with a code of magnitude ¾R or more is a reflex one, and codes below that count as 0 in
/// it; so that the distance is continuous, none should have both. Where no two codes have different
/// signs the distance is the bilinear interpolation as ever.
struct ShapeCreases {
    Plane code;
    /// A field below the distance that steps go by: it differs between two texel centres by no more
    /// than the way between them (and the slack), as true distances do.
    Plane step;
};

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
    ShapeCreases creases{};  ///< planes without texels: none

    [[nodiscard]] int width() const noexcept { return distance.width; }
    [[nodiscard]] int height() const noexcept { return distance.height; }
    /// ρ: height of the tile over its width.
    [[nodiscard]] double aspect() const noexcept {
        return static_cast<double>(distance.height) / static_cast<double>(distance.width);
    }
    [[nodiscard]] bool isCreased() const noexcept { return !creases.code.texels.empty(); }
    /// Whether the crease at a texel is a reflex one. Needs creases.
    [[nodiscard]] bool isReflex(std::size_t texel) const noexcept {
        return std::abs(creases.code.texels[texel]) * static_cast<float>(distance.width) >=
               static_cast<float>(kLeastReflexTexels);
    }
    /// What steps go by.
    [[nodiscard]] const Plane& steps() const noexcept {
        return isCreased() ? creases.step : distance;
    }
    /// Whether steps may go by the distance itself as long as the offset (tile widths) is at least
    /// that.
    [[nodiscard]] bool isBeyondCorners(double offset) const noexcept {
        return !isCreased() || offset * width() >= kCornersEndTexels;
    }
};

/// The most that the step of a texel of a creased map can be for the cells around it: where two
/// codes have different signs a convex cell is at least the mean of A and B, a reflex one at least
/// the interpolation of its distances.
float mostStep(const ShapeMap& shape, std::size_t texel) noexcept;

/// By how much the distance is above the interpolation of steps() anywhere, at most, in tile
/// widths; 0 without creases.
double creaseDepth(const ShapeMap& shape) noexcept;

/// The shape that a map set of the kind `shape` describes: channels `distance`, `gx`, `gy` and
/// `shape`, and with creases `crease` and `step`; attributes `relievo:signed` ("0" or "1") and
/// `relievo:slack`. Throws InputError that names the channel or attribute which is missing or
/// senseless.
ShapeMap shapeMapOf(const MapSet& maps);

/// The inverse: the map set of a shape.
MapSet mapSetOf(const ShapeMap& shape);

}  // namespace relievo::textures
