#pragma once

#include <array>
#include <span>

namespace relievo::preprocess {

/// A plane that is nowhere above a surface over a rectangle of samples: at its first sample, and
/// depth per texel along both axes.
///
/// The planes are what makes smooth slopes cheap to search: the least depth of a rectangle lies at
/// its far corner and the least distance at its near one, so that a bound from these two is loose
/// on a slope, and nearly all rectangles along it must be opened. A plane below the surface is tight
/// there.
struct LowerPlane {
    float base = 0.0f;
    float slopeX = 0.0f;
    float slopeY = 0.0f;
};

/// What the roundings of some sixteen floats may take off a bound by a plane, in depth: none of
/// them is above 2 for a rectangle that matters, because then the product of slope and distance is
/// no more than the depths, and that of slope and the extent of the apexes less still.
inline constexpr float kPlaneRounding = 2e-6f;

/// A part of a rectangle with a plane of its own.
struct PlanePart {
    LowerPlane plane;
    int column;  ///< its first sample, from that of the whole rectangle
    int row;
    int right;  ///< its last sample, from its first
    int bottom;
};

/// The plane below 2×2 samples, in the order of ReliefQuad, with their mean slope; +infinity for
/// samples that do not exist.
LowerPlane planeBelow(const std::array<float, 4>& depths);

/// The plane below one to four parts of a rectangle, from theirs: with their mean slope, and as high
/// as they allow at their corners.
LowerPlane planeBelow(std::span<const PlanePart> parts);

}  // namespace relievo::preprocess
