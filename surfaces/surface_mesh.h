#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

namespace relievo::surfaces {

/// A vertex of a surface that carries a relief. World space is right-handed with z up; (u,v) has
/// its origin at the top left of the picture.
struct SurfaceVertex {
    glm::vec3 position;
    glm::vec3 normal;     ///< unit length, towards the outside
    glm::vec3 tangent;    ///< ∂position/∂u: its length is the width of a tile in world units
    glm::vec3 bitangent;  ///< ∂position/∂v
    glm::vec2 uv;
};

/// The border of a window that ends nowhere.
inline constexpr float kNoBorder = std::numeric_limits<float>::infinity();

/// A coarse triangle mesh with tangent frames; triangles are counter-clockwise from outside.
struct SurfaceMesh {
    std::vector<SurfaceVertex> vertices;
    std::vector<std::uint32_t> indices;
    /// The part of (u,v) that every face covers; the relief ends there. Curved surfaces have
    /// windows without borders: the relief goes on as its map is wrapped.
    glm::vec2 windowMinimum{0.0f};
    glm::vec2 windowMaximum{1.0f};
};

/// How much room a surface takes in the world.
struct SurfaceExtent {
    glm::vec3 minimum{0.0f};  ///< corners of the box along the axes around all vertices
    glm::vec3 maximum{0.0f};
    float widestTile = 0.0f;  ///< the longest tangent
};

/// The extent of a mesh; that of an empty one is all zeros.
SurfaceExtent extentOf(const SurfaceMesh& mesh);

/// The number of times that a map is repeated across a face, in u and v; both > 0.
using Tiles = glm::vec2;

/// A rectangle in the plane z = 0 that faces up, centred at the origin and 1 wide; its height keeps
/// the texels of a map of aspect ρ = height/width square: ρ·tiles.y/tiles.x. u grows along +x, v
/// along −y.
SurfaceMesh makeQuad(Tiles tiles, float aspect);

/// The cube [−½,½]³ with the map on each of its six faces, the reliefs sunk into it. Texels are
/// square where aspect·tiles.y = tiles.x.
SurfaceMesh makeBox(Tiles tiles);

/// The box between two corners of the space of a solid, as `toWorld` (affine, invertible) has it in
/// the world: what a solid in a box is drawn from (specification 7.4). It has positions only.
SurfaceMesh makeShapeBox(const glm::dvec3& low, const glm::dvec3& high, const glm::dmat4& toWorld);

/// `mesh` moved by the affine map `placement`, which must be invertible. A mirroring one turns the
/// triangles round, so that they stay counter-clockwise from outside.
SurfaceMesh placed(SurfaceMesh mesh, const glm::mat4& placement);

}  // namespace relievo::surfaces
