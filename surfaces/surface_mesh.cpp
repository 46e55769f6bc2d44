#include "surfaces/surface_mesh.h"

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <utility>

namespace relievo::surfaces {
namespace {

// Adds a rectangle: `right` and `down` are its whole sides, along which u and v grow.
void addFace(SurfaceMesh& mesh, glm::vec3 center, glm::vec3 right, glm::vec3 down, Tiles tiles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const glm::vec3 normal = glm::normalize(glm::cross(down, right));
    for (const glm::vec2 corner :
         {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        const glm::vec3 position = center + (corner.x - 0.5f) * right + (corner.y - 0.5f) * down;
        mesh.vertices.push_back(
            {position, normal, right / tiles.x, down / tiles.y, corner * tiles});
    }
    // Top left, bottom left, bottom right, top right: counter-clockwise seen against the normal.
    for (const std::uint32_t k : {0u, 3u, 2u, 0u, 2u, 1u})
        mesh.indices.push_back(first + k);
}

}  // namespace

SurfaceExtent extentOf(const SurfaceMesh& mesh) {
    SurfaceExtent extent;
    if (mesh.vertices.empty())
        return extent;
    extent.minimum = extent.maximum = mesh.vertices.front().position;
    for (const SurfaceVertex& vertex : mesh.vertices) {
        extent.minimum = glm::min(extent.minimum, vertex.position);
        extent.maximum = glm::max(extent.maximum, vertex.position);
        extent.widestTile = std::max(extent.widestTile, glm::length(vertex.tangent));
    }
    return extent;
}

SurfaceMesh makeQuad(Tiles tiles, float aspect) {
    assert(tiles.x > 0 && tiles.y > 0 && aspect > 0);
    SurfaceMesh mesh;
    mesh.windowMaximum = tiles;
    addFace(mesh, glm::vec3(0), {1, 0, 0}, {0, -aspect * tiles.y / tiles.x, 0}, tiles);
    return mesh;
}

SurfaceMesh makeBox(Tiles tiles) {
    assert(tiles.x > 0 && tiles.y > 0);
    SurfaceMesh mesh;
    mesh.windowMaximum = tiles;
    addFace(mesh, {0, 0, 0.5f}, {1, 0, 0}, {0, -1, 0}, tiles);
    addFace(mesh, {0, 0, -0.5f}, {1, 0, 0}, {0, 1, 0}, tiles);
    addFace(mesh, {0, -0.5f, 0}, {1, 0, 0}, {0, 0, -1}, tiles);
    addFace(mesh, {0, 0.5f, 0}, {-1, 0, 0}, {0, 0, -1}, tiles);
    addFace(mesh, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, -1}, tiles);
    addFace(mesh, {-0.5f, 0, 0}, {0, -1, 0}, {0, 0, -1}, tiles);
    return mesh;
}

SurfaceMesh makeShapeBox(const glm::dvec3& low, const glm::dvec3& high, const glm::dmat4& toWorld) {
    // The unit cube's vertices have normals and frames of the cube; nothing reads them.
    const glm::dvec3 size = high - low;
    glm::dmat4 fromCube(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        fromCube[axis][axis] = size[axis];
        fromCube[3][axis] = low[axis] + 0.5 * size[axis];
    }
    return placed(makeBox({1.0f, 1.0f}), glm::mat4(toWorld * fromCube));
}

SurfaceMesh placed(SurfaceMesh mesh, const glm::mat4& placement) {
    const glm::mat3 linear(placement);
    const float determinant = glm::determinant(linear);
    assert(determinant != 0.0f);
    const glm::mat3 normals = glm::inverseTranspose(linear);
    for (SurfaceVertex& vertex : mesh.vertices) {
        vertex.position = glm::vec3(placement * glm::vec4(vertex.position, 1.0f));
        vertex.normal = glm::normalize(normals * vertex.normal);
        vertex.tangent = linear * vertex.tangent;
        vertex.bitangent = linear * vertex.bitangent;
    }
    if (determinant < 0.0f)
        for (std::size_t k = 0; k < mesh.indices.size(); k += 3)
            std::swap(mesh.indices[k + 1], mesh.indices[k + 2]);
    return mesh;
}

}  // namespace relievo::surfaces
