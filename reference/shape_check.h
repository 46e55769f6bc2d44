#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "reference/bilinear_tracer.h"
#include "textures/shape_map.h"

namespace relievo::reference {

/// The step, in texels, that a search may take in any direction along a shape map where the
/// bilinear distance (with creases: that of ShapeMap::steps()) is more than the offset of the solid
/// and the map's slack by `free` > 0 (texels): the points nearer than max(free/√2, √(free² − ½))
/// are outside {d ≤ offset}.
///
/// Why: the samples are true distances but for the slack ε, so that s(x) − s(y) ≤ |x − y| + ε
/// between any two centres (each is off towards 0, by at most ε). The bilinear distance at P is the
/// mean of s(X) over a random X, each coordinate of P rounded down or up, in texels, with chances
/// that make P the mean of X. Round Q with the same random numbers: then X − Y is, in each
/// coordinate, one of the two whole numbers around P − Q, which is its mean. So
/// d(P) − d(Q) ≤ ε + E|X − Y|, and E|X − Y| ≤ E|X − Y|₁ = |P − Q|₁ ≤ √2·|P − Q|, since all these
/// numbers have the sign of their mean; and E|X − Y|² = |P − Q|² + variance, which is at most ¼ for
/// each coordinate. Under clamp places outside the tile are moved to its border, which brings no
/// two of them farther apart. With creases the samples are those of ShapeCreases::step, whose
/// interpolation is nowhere above the distance.
///
/// At offsets of textures::kCornersEndTexels and more they may be the distances themselves. Let e
/// be the larger one of a true distance and E = kCornersEndTexels − √2: a field as above, which the
/// samples are but where true distances are at most E. In a cell with such a sample e is nowhere
/// above E + √2: where e is above the offset there is none. And elsewhere there is no convex
/// crease, so that the distance is no less than the interpolation of samples, which is that of e.
double safeStep(double free) noexcept;

/// How to check a map.
struct ShapeCheckOptions {
    std::uint64_t rays = 1'000'000;
    std::uint64_t seed = 1;
    /// Called from any thread with the number of rays just finished.
    std::function<void(std::size_t)> advance;
};

/// A step that entered the solid.
struct ShapeViolation {
    std::uint64_t ray = 0;  ///< which of the rays drawn
    TileRay step;           ///< z is the offset; the direction has metric length 1
    double length = 0.0;    ///< of the step, in tile widths
    double worstAt = 0.0;   ///< the distance along the step at which it is deepest
    double depth = 0.0;     ///< by how much the offset is above the distance there, in tile widths
};

/// What a check found.
struct ShapeReport {
    std::uint64_t rays = 0;
    std::uint64_t violations = 0;
    std::optional<ShapeViolation> worst;
    /// Texels whose distance is above 0 although more than a half is inside, or below 0 although
    /// less is; the half of an 8-bit code does not count.
    std::uint64_t contradictions = 0;
    double meanStep = 0.0;  ///< of the steps taken, in texels
};

/// Draws places, offsets in the range of the distances (from 0 on in an unsigned map; with creases
/// every other time of distances beyond corners) and directions, many of them at texels to which
/// the distances fall the fastest, and takes the step that safeStep allows, for two tiles at most.
/// It is followed exactly through the bilinear cells, in double precision; a step that gets more
/// than 10⁻⁹ tile widths into {d ≤ offset} breaks the promise. The report depends on the arguments
/// alone, not on threads.
ShapeReport checkShape(const textures::ShapeMap& shape, const ShapeCheckOptions& options = {});

}  // namespace relievo::reference
