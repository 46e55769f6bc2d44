#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "textures/map_set.h"

namespace relievo::viewer {

/// D(u,v) = 0.2 + 0.3u + 0.2v + 0.25uv: bilinear all over, so that within the outermost texel
/// centres interpolated depths and slopes are those of the formula.
double bilinearDepth(glm::dvec2 uv);

/// ∂D/∂u, ∂D/∂v.
glm::dvec2 bilinearSlope(glm::dvec2 uv);

/// Its unit normal in the tile's metric, z up, at a depth scale, for a map of aspect ρ.
glm::dvec3 bilinearNormalAt(glm::dvec2 uv, double aspect, double depthScale);

/// Depths, derivatives, and normals for the depth scale 0.1, all from the formula; clamped.
textures::MapSet bilinearMaps(int width, int height);

}  // namespace relievo::viewer
