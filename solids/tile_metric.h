#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace relievo::solids {

/// What lengths in the tile space of a part are in the world, for an affine placement of any kind.
///
/// With δ = (δu, δv, δz): |world·δ|² ≥ horizontal²·(δu² + (rowScale·δv)²) + vertical²·δz². It is an
/// equation for placements that keep the tile's axes at right angles and its texels square.
struct TileMetric {
    double horizontal = 0.0;  ///< world length of a tile width
    double vertical = 0.0;    ///< world length of a unit of z
    /// World distance of planes at right angles to each axis that are a unit of it apart.
    glm::dvec3 slab{0.0};
};

/// The metric of `world`, which takes vectors of tile space to the world; invertible. `rowScale`:
/// how long a unit of v is in those of u, ρ for extrusions and 1 for revolutions.
TileMetric tileMetric(const glm::dmat3& world, double rowScale);

}  // namespace relievo::solids
