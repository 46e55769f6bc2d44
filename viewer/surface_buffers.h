#pragma once

#include "gl/buffer.h"
#include "surfaces/surface_mesh.h"

namespace relievo::viewer {

/// A surface on the GPU, with the attributes that programs/surface.vert reads. Move only. Needs its
/// context whenever it is used, and when it is destroyed.
class SurfaceBuffers {
  public:
    explicit SurfaceBuffers(const surfaces::SurfaceMesh& mesh);

    /// Draws all triangles with the current program.
    void draw() const;

    [[nodiscard]] const surfaces::SurfaceExtent& extent() const noexcept { return extent_; }

  private:
    gl::VertexArray vertexArray_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLsizei indexCount_ = 0;
    surfaces::SurfaceExtent extent_;
};

}  // namespace relievo::viewer
