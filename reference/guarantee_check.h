#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "reference/bilinear_tracer.h"
#include "reference/roof_map.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::reference {

/// What the steps of a cone map promise (specification 3.2 and 3.3).
enum class ConePromise {
    Conservative,  ///< no step passes the first hit
    Relaxed,       ///< no step comes out of the relief again
};

/// How to check a map.
struct GuaranteeCheckOptions {
    std::uint64_t rays = 1'000'000;
    std::uint64_t seed = 1;
    /// Called from any thread with the number of rays just finished.
    std::function<void(std::size_t)> advance;
};

/// A step that broke the promise.
struct GuaranteeViolation {
    std::uint64_t ray = 0;  ///< which of the rays drawn
    int i = 0;              ///< the texel whose cone was stepped by
    int j = 0;
    TileRay step;          ///< where it starts; its direction has metric length 1
    double length = 0.0;   ///< of the step, in tile widths at a depth scale of 1
    double worstAt = 0.0;  ///< the distance along the step at which it is farthest off
    /// How far off, in depth: below the surface, or for relaxed cones above it again.
    double depth = 0.0;
};

/// What a check found.
struct GuaranteeReport {
    std::uint64_t rays = 0;
    std::uint64_t violations = 0;
    std::optional<GuaranteeViolation> worst;  ///< the farthest off
    double meanRatio = 0.0;                   ///< of the texels whose cone has a limit
    std::uint64_t unlimited = 0;  ///< texels of kLargestHalf (the most that is stored) or more
};

/// Draws rays that start above the bilinear surface of `relief` (adversarial_rays.h), takes the
/// cone step of each and traces it exactly, in double precision. The step is that of a search which
/// reads the ratio of the texel that holds the point (NEAREST) and the depth of the surface there
/// (LINEAR): from (P,z) it goes on to where the ray leaves the cone with its apex on the surface
/// below P. `ratios` are in tile widths per unit of depth, ≥ 0, infinite where unlimited: one for
/// each of 1, 4 or 8 sectors of directions (ray_sector.h).
///
/// One step a ray is enough: those of a whole march are such steps too. A step is followed for two
/// tiles; cones that hold something hold the nearest copy of it as well. What goes wrong by no more
/// than kPiercingDepth does not count. The report depends on the arguments alone, not on threads.
GuaranteeReport checkCones(const textures::DepthMap& relief,
                           std::span<const textures::Plane> ratios, ConePromise promise,
                           const GuaranteeCheckOptions& options = {});
inline GuaranteeReport checkCones(const textures::DepthMap& relief, const textures::Plane& ratio,
                                  ConePromise promise, const GuaranteeCheckOptions& options = {}) {
    return checkCones(relief, std::span(&ratio, 1), promise, options);
}

/// The same for roof cones, which promise what conservative ones do: from (P,z) in a cell, z above
/// its roof, the step goes on to the later of where the ray leaves the cone with its apex on the
/// roof, and of where it comes down to the roof or leaves the block, whichever is first.
GuaranteeReport checkRoofs(const textures::DepthMap& relief, const RoofMap& roofs,
                           const GuaranteeCheckOptions& options = {});

}  // namespace relievo::reference
