#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/bilinear_tracer.h"
#include "textures/depth_map.h"

namespace relievo::reference {

/// A light far away, as a point of the relief sees it: a disc whose directions are
/// centre + x·lift + y·side with x² + y² ≤ 1, in tile space (z < 0 is up) and of any length.
struct DiscLight {
    glm::dvec3 centre{0.0, 0.0, -1.0};
    glm::dvec3 lift{0.0};  ///< 0 for a light that is a point, like `side`
    glm::dvec3 side{0.0};
};

/// Whether light from `direction` (tile space) gets to the point of the bilinear surface of `map`
/// at (u,v) `place`, which must lie in `window`: whether the ray that leaves the surface there goes
/// up and never gets more than kPiercingDepth below the surface within the window. The ray begins
/// on the surface, so its first root is no matter, and what it merely touches, the surface at its
/// own point included, is not in its way.
bool isLit(const textures::DepthMap& map, const glm::dvec2& place, const glm::dvec3& direction,
           const TileWindow& window = {}, double maxDistance = 1e3);

/// The share of a light's disc from which light gets there, by `rays` ≥ 1 rays that are spread
/// evenly over the disc in a spiral, always the same. A straight shadow edge is found with an error
/// under 1/√rays, usually far under; a light that is a point takes one ray.
double visibleShare(const textures::DepthMap& map, const glm::dvec2& place, const DiscLight& light,
                    int rays, const TileWindow& window = {}, double maxDistance = 1e3);

}  // namespace relievo::reference
