#pragma once

#include <array>
#include <glm/geometric.hpp>

#include "surfaces/surface_mesh.h"

namespace relievo::surfaces {

/// For every triangle: uv and positions must agree with the tangent frame, the winding with the
/// normal. True only of correct meshes with flat faces.
inline bool framesAgree(const SurfaceMesh& mesh) {
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
        const std::array<const SurfaceVertex*, 3> corner = {&mesh.vertices[mesh.indices[k]],
                                                            &mesh.vertices[mesh.indices[k + 1]],
                                                            &mesh.vertices[mesh.indices[k + 2]]};
        const SurfaceVertex& first = *corner[0];
        for (std::size_t c = 1; c < 3; ++c) {
            const glm::vec2 uv = corner[c]->uv - first.uv;
            const glm::vec3 edge = corner[c]->position - first.position;
            if (glm::length(uv.x * first.tangent + uv.y * first.bitangent - edge) > 1e-6f)
                return false;
        }
        const glm::vec3 winding =
            glm::cross(corner[1]->position - first.position, corner[2]->position - first.position);
        if (glm::length(glm::normalize(winding) - first.normal) > 1e-6f)
            return false;
    }
    return !mesh.indices.empty();
}

}  // namespace relievo::surfaces
