#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace relievo::reference {

/// What one search returned for one ray, and what is true for it. Distances are arc lengths along
/// the ray in the depth-scaled metric, in tile widths: |(du, ρ·dv, a·dz)|.
struct HitComparison {
    bool found = false;     ///< the technique reported a hit
    bool converged = true;  ///< the technique says that its search converged
    bool exists = false;    ///< there is a true first hit
    double distance = 0.0;  ///< of the technique's hit, from the ray's origin
    double exactDistance = 0.0;
    glm::dvec3 normal{0, 0, 1};  ///< unit normal that the technique shades with
    glm::dvec3 exactNormal{0, 0, 1};
};

/// Errors of one technique over many rays. Distances are in tile widths, angles in degrees, shares
/// in [0,1] of all rays. Distance and angle statistics are over the compared rays; the 99th
/// percentile is by nearest rank, the smallest value that at least 99 % of them do not exceed.
struct ErrorStatistics {
    std::size_t rays = 0;
    std::size_t compared = 0;  ///< rays on which both have a hit, the technique's a finite one
    double wrongShare = 0.0;   ///< hit against miss, unconverged, or off by over the tolerance
    double unconvergedShare = 0.0;
    double overshotShare = 0.0;  ///< off by over the tolerance, behind the true hit
    double meanDistance = 0.0;   ///< of |distance − exactDistance|
    double percentile99Distance = 0.0;
    double maximumDistance = 0.0;
    double meanNormalAngle = 0.0;
    double percentile99NormalAngle = 0.0;
};

/// Statistics of `comparisons`; a first hit counts as wrong when it is off by more than `tolerance`
/// tile widths along the ray (usually one texel, 1/W). A hit whose distance or normal is not finite
/// counts as wrong and is not compared. An empty span gives all zeros.
ErrorStatistics summarizeErrors(std::span<const HitComparison> comparisons, double tolerance);

}  // namespace relievo::reference
