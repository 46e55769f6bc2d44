#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "reference/cell_walk.h"
#include "textures/depth_map.h"

namespace relievo::reference {

/// A ray that comes down on the relief, parametrised by its depth: P(z) = start + z·slope in (u,v),
/// 0 ≤ z ≤ 1.
struct DescendingRay {
    glm::dvec2 start{0.0};
    glm::dvec2 slope{0.0};  ///< tiles along u and v per unit of depth

    [[nodiscard]] glm::dvec2 at(double z) const noexcept { return start + z * slope; }
    /// s: tile widths per unit of depth, in the metric of a tile of height/width `aspect`.
    [[nodiscard]] double speed(double aspect) const noexcept;
};

/// The ray from `start` that comes from `elevation` above the surface when the depth of 1 is
/// `depthScale` tile widths, and goes along `azimuth`; both in radians, over a tile of height/width
/// `aspect`.
DescendingRay descendingRay(const glm::dvec2& start, double elevation, double azimuth,
                            double depthScale, double aspect);

/// What a search on maps found, in double precision, and what it took.
struct MapSearchResult {
    double z = 1.0;         ///< depth of the hit
    bool converged = true;  ///< false: gave up above the surface
    int lookups = 0;        ///< fetches of a texel, a filtered sample or a gather of four
};

/// The walk of a ray over the cells; its parameter is the depth z.
CellWalk walkOver(const textures::DepthMap& relief, const DescendingRay& ray);

/// The depth at which a ray, which enters the walk's current cell above the surface or on it, meets
/// it in that cell; nothing when it leaves the cell above it. What a shader does with one gather
/// and one quadratic.
std::optional<double> hitInCell(const CellWalk& walk);

}  // namespace relievo::reference
