#pragma once

#include <array>
#include <vector>

#include "reference/error_metrics.h"
#include "solids/solid_tracer.h"
#include "viewer/measured_frame.h"

namespace relievo::bench {

/// The metric of a frame's rays: |(du, ρ·dv, a·dz)| in tile widths, and whether there is a floor.
struct SolidSpace {
    double aspect = 1.0;
    double depthScale = 1.0;  ///< of revolutions ρ: their depth has the metric of the map
    bool hasFloor = false;
};

/// What a ray meets first.
struct FirstHit {
    bool exists = false;
    bool isFloor = false;   ///< z = 1 of an extrusion, where the solid is not
    double distance = 0.0;  ///< along the ray, in tile widths
};

/// What a ray meets first in the solid, and in one that is kSolidTie larger and smaller all around.
/// Where these differ the ray passes so close by a surface that the rounding of floats decides.
struct RayTruth {
    FirstHit exact;
    std::array<FirstHit, 2> tied;
};
inline constexpr double kSolidTie = 1e-3;  ///< texels

/// Shares in [0,1] of the rays, by what is wrong with them. A search that says that its steps ran
/// out is in none of them.
struct SolidFaults {
    double behind = 0.0;   ///< a hit over a texel behind the first one: what is in front was passed
    double lost = 0.0;     ///< no hit, or the floor, where there is one
    double inFront = 0.0;  ///< a hit over a texel in front of the first one, or where there is none
};

/// What a search got wrong.
struct SolidErrors {
    reference::ErrorStatistics errors;
    SolidFaults faults;
    /// Share of the rays whose hit is that of the larger or the smaller solid, not of the exact
    /// one. They are right.
    double tiedShare = 0.0;
};

/// The exact first hits with a solid of one part, in double precision.
class SolidTruth {
  public:
    explicit SolidTruth(const solids::SolidPart& part);

    /// Of the rays of the covered pixels, on all cores.
    [[nodiscard]] std::vector<RayTruth> trace(const viewer::MeasuredFrame& frame,
                                              const SolidSpace& space) const;

  private:
    std::array<solids::SolidTracer, 3> tracers_;  // the solid, larger, smaller
};

/// The errors of a frame's searches; a hit is right within `tolerance` tile widths along its ray.
SolidErrors compareWithSolid(const viewer::MeasuredFrame& frame, const std::vector<RayTruth>& truth,
                             const SolidSpace& space, double tolerance);

}  // namespace relievo::bench
