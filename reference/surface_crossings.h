#pragma once

#include <vector>

#include "reference/bilinear_tracer.h"
#include "textures/depth_map.h"

namespace relievo::reference {

/// A ray counts as below the surface, or above it again, from this depth on (specification 1), so
/// that rounding and mere touches do not count.
inline constexpr double kPiercingDepth = 1e-6;

/// A place where a ray passes through the surface.
struct SurfaceCrossing {
    double t = 0.0;
    bool enters = false;  ///< goes below the surface; else it comes out
};

/// All places, in order, where the bilinear surface of `map` is passed by the ray's piece
/// 0 ≤ t ≤ `end` (finite), found exactly: cell by cell, between the extremes of the quadratic of
/// each. A crossing counts when the ray gets more than `tolerance` ≥ 0 of depth beyond it before it
/// crosses back; entries and exits alternate. A ray that begins more than the tolerance below the
/// surface has an exit first. The ray is not clipped: z may be anything.
std::vector<SurfaceCrossing> surfaceCrossings(const textures::DepthMap& map, const TileRay& ray,
                                              double end, double tolerance = kPiercingDepth);

/// Whether the ray's piece 0 ≤ t ≤ `end` (finite) gets more than `tolerance` ≥ 0 of depth below the
/// surface. Walks no further than to the first place where it does.
bool getsBelow(const textures::DepthMap& map, const TileRay& ray, double end,
               double tolerance = kPiercingDepth);

/// How far a piece of a ray goes to one side of the surface, in depth, and where.
struct Excursion {
    double depth = 0.0;  ///< 0: never
    double t = 0.0;
};

/// The deepest that the ray's piece 0 ≤ t ≤ `end` (finite) gets below the surface: what a safe step
/// keeps at 0.
Excursion deepestBelow(const textures::DepthMap& map, const TileRay& ray, double end);

/// The farthest that the ray's piece 0 ≤ t ≤ `end` (finite) gets above the surface after it was
/// more than `tolerance` below it: what a relaxed cone keeps at 0.
Excursion farthestReappearance(const textures::DepthMap& map, const TileRay& ray, double end,
                               double tolerance = kPiercingDepth);

}  // namespace relievo::reference
