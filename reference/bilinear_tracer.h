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
    /// The ray began below the surface, or came into the window below it: t is 0 or where it came
    /// in. A ray that begins exactly on the surface hits at its origin and is not inside.
    bool startsInside = false;
};

/// The exact first hit of `ray` with the bilinear surface of `map` inside `window`, or nothing.
/// Walks the bilinear cells (DDA on integers) and solves the quadratic of each, in double
/// precision. Handles vertical, level, rising and axis-parallel rays, origins outside the window,
/// all wrap modes and any map size from 1×1; a direction of zero length hits only what it is in.
///
/// No ray is followed for more than `maxDistance` (finite) tile widths of horizontal distance
/// inside the window, so that one that never leaves it (level, above the surface of a repeated map)
/// ends too. A ray with components that are not finite, or that enters the window so far out that
/// doubles do not resolve its texels (2⁵¹ of them), has no hit.
std::optional<TileHit> traceBilinear(const textures::DepthMap& map, const TileRay& ray,
                                     const TileWindow& window = {}, double maxDistance = 1e3);

/// The unit normal of the relief at (u,v) when its depth is scaled by `depthScale` (a, in tile
/// widths): normalize(a·∂D/∂u, a·∂D/∂v, 1) in the metric, z up, from the bilinear cell itself. On
/// the border of two cells it is that of the cell to the right or below.
glm::dvec3 bilinearNormal(const textures::DepthMap& map, double u, double v, double depthScale);

}  // namespace relievo::reference
