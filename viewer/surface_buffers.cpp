#include "viewer/surface_buffers.h"

#include <cstddef>
#include <span>

#include "shaders/relievo/constants.h"

namespace relievo::viewer {

SurfaceBuffers::SurfaceBuffers(const surfaces::SurfaceMesh& mesh)
    : vertices_(std::as_bytes(std::span(mesh.vertices))),
      indices_(std::as_bytes(std::span(mesh.indices))),
      indexCount_(static_cast<GLsizei>(mesh.indices.size())),
      extent_(surfaces::extentOf(mesh)) {
    using surfaces::SurfaceVertex;
    const auto attribute = [&](GLuint location, int components, std::size_t offset) {
        vertexArray_.attribute(location, vertices_, components, sizeof(SurfaceVertex), offset);
    };
    attribute(RELIEVO_ATTRIBUTE_POSITION, 3, offsetof(SurfaceVertex, position));
    attribute(RELIEVO_ATTRIBUTE_NORMAL, 3, offsetof(SurfaceVertex, normal));
    attribute(RELIEVO_ATTRIBUTE_TANGENT, 3, offsetof(SurfaceVertex, tangent));
    attribute(RELIEVO_ATTRIBUTE_BITANGENT, 3, offsetof(SurfaceVertex, bitangent));
    attribute(RELIEVO_ATTRIBUTE_UV, 2, offsetof(SurfaceVertex, uv));
    vertexArray_.indices(indices_);
}

void SurfaceBuffers::draw() const {
    vertexArray_.bind();
    glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace relievo::viewer
