#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "textures/depth_map.h"

namespace relievo::reference {

/// A ray in tile space: x = u, y = v, z = normalised depth (0 reference surface, 1 bottom, growing
/// downwards). P(t) = origin + t·direction, t ≥ 0; the direction need not be normalised.
struct TileRay {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0};
};

/// The part of tile space in which the relief exists: (u,v) in [minimum, maximum], z in [0,1].
/// Unbounded by default; bounds may be infinite.
struct TileWindow {
    glm::dvec2 minimum{-std::numeric_limits<double>::infinity()};
    glm::dvec2 maximum{std::numeric_limits<double>::infinity()};
};

/// The first point of a ray in the solid {z ≥ D(u,v)}.
struct TileHit {
    double t = 0.0;
    glm::dvec3 position{0.0};  ///< (u,v,z)
    bool startsInside =
        false;  ///< the ray began below the surface: t is where it entered the window
};

/// The exact first hit of `ray` with the bilinear surface of `map`, or nothing. Walks the bilinear
/// cells (DDA on integers) and solves the quadratic of each, in double precision. Handles vertical,
/// level, rising and axis-parallel rays, all wrap modes and any map size from 1×1.
///
/// A ray that never leaves an unbounded window (level, above the surface of a repeated map) is
/// given up after `maxDistance` tile widths of horizontal distance.
std::optional<TileHit> traceBilinear(const textures::DepthMap& map, const TileRay& ray,
                                     const TileWindow& window = {}, double maxDistance = 1e3);

/// The unit normal of the relief at (u,v) when its depth is scaled by `depthScale` (a, in tile
/// widths): normalize(a·∂D/∂u, a·∂D/∂v, 1) in the metric, z up, from the bilinear cell itself.
glm::dvec3 bilinearNormal(const textures::DepthMap& map, double u, double v, double depthScale);

}  // namespace relievo::reference
