#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "reference/error_metrics.h"
#include "solids/solid.h"
#include "textures/plane.h"
#include "viewer/error_image.h"
#include "viewer/measured_frame.h"

namespace relievo::viewer {

/// The space of a whole that is measured.
struct SolidMetric {
    glm::dvec3 texels{1.0};  ///< how long a unit of u, of v and of z is, in texels of the map
    bool hasFloor = false;   ///< what is not hit is hit at z = 1
};

/// How far every pixel of a frame is from the exact first hit of its ray.
struct SolidErrors {
    ErrorImage image;                       ///< without angles: its normalAngle has no texels
    reference::ErrorStatistics statistics;  ///< in texels; wrong is what is off by over one
};

/// Traces the very rays of `frame`, which shows `compound`, in double precision on all cores.
SolidErrors measureSolidErrors(const MeasuredFrame& frame, const solids::Compound& compound,
                               const SolidMetric& metric);

/// The planes under the names `prefix.distance`, `.verdict`, `.steps` and `.fetches`.
std::vector<NamedPlane> namedPlanes(const SolidErrors& errors, const std::string& prefix);

}  // namespace relievo::viewer
