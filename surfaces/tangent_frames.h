#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "surfaces/surface_mesh.h"

namespace relievo::surfaces {

/// Triangles as files have them. All numbers are finite.
struct TriangleMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> uv;           ///< one a position, or none at all
    std::vector<glm::vec3> normals;      ///< likewise; (0,0,0) where there is none
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise from outside
};

/// The width of the tile at a vertex whose triangles have uv that say nothing of directions: too
/// small for a relief to be seen.
inline constexpr float kTinyTile = 1e-6f;

/// The mesh with a tangent frame per vertex (specification 5): the tangents are the partial
/// derivatives of the position by u and v, neither normalised nor made perpendicular, each
/// triangle's counting as much as it covers of (u,v), in the plane across the normal. Tangents are
/// averaged over the triangles that share a vertex with its uv and their handedness: where mirrored
/// and plain uv meet, the vertex becomes two. Normals that are missing are averaged over all that
/// share the position, by the angles there. Triangles without an area are left out, vertices that
/// none uses too. Without uv all uv are 0. The window has no borders.
SurfaceMesh withTangentFrames(const TriangleMesh& mesh);

}  // namespace relievo::surfaces
