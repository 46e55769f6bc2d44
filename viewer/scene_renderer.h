#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "materials/program_cache.h"
#include "materials/relief_maps.h"
#include "materials/relief_material.h"
#include "surfaces/surface_mesh.h"
#include "textures/map_set.h"
#include "viewer/camera.h"
#include "viewer/measured_frame.h"
#include "viewer/picture.h"
#include "viewer/reference_frame.h"

namespace relievo::viewer {

/// What is seen, apart from the technique that shows it.
struct View {
    Camera camera;
    glm::vec3 toLight{0, 0, 1};    ///< unit vector
    float depthScale = 0.1f;       ///< a, in tile widths
    glm::vec4 window{0, 0, 1, 1};  ///< minimum u, v, maximum u, v of the relief
    bool markExhausted = false;    ///< paint searches that ran out of steps magenta, not as holes
};

/// A relief on a surface, drawn with any technique. Needs a current context for its whole life; it
/// draws to framebuffer objects only, so that a window and a headless run share every step.
class SceneRenderer {
  public:
    /// `name` stands for the relief in error messages. An empty albedo means plain grey.
    SceneRenderer(textures::MapSet maps, const std::string& name, const Picture& albedo);

    void setSurface(const surfaces::SurfaceMesh& mesh);

    /// A material of this relief with the parameters' defaults. Throws textures::InputError when
    /// the map lacks a channel that the technique needs.
    materials::ReliefMaterial makeMaterial(const materials::Technique& technique) const;

    /// Draws the shaded relief over a background of (0.09, 0.09, 0.1) into attachment 0 of
    /// `target`.
    void draw(materials::ReliefMaterial& material, const View& view, gl::Framebuffer& target);
    /// Draws the exact picture: hits of the reference through the same shading. The frame's size
    /// must be that of `target`.
    void drawReference(const ReferenceFrame& reference, const View& view, gl::Framebuffer& target);
    /// Records the searches of every pixel.
    MeasuredFrame measure(materials::ReliefMaterial& material, const View& view, int width,
                          int height);
    /// The rays of every pixel, for traceReference; what was measured besides means nothing.
    MeasuredFrame rays(const View& view, int width, int height);
    /// The exact hits of the rays of the same view.
    ReferenceFrame trace(const View& view, int width, int height);

    [[nodiscard]] const textures::DepthMap& depthMap() const noexcept { return depthMap_; }
    [[nodiscard]] const textures::MapSet& maps() const noexcept { return reliefMaps_->maps(); }

  private:
    void drawSurface(gl::Program& program, materials::ReliefMaterial& material, const View& view,
                     const gl::Texture* givenHits);
    void drawShaded(materials::ReliefMaterial& material, const View& view, gl::Framebuffer& target,
                    const gl::Texture* givenHits);

    textures::DepthMap depthMap_;
    std::shared_ptr<materials::ReliefMaps> reliefMaps_;
    gl::Texture albedo_;
    bool hasAlbedo_ = false;
    materials::ProgramCache programs_;
    gl::VertexArray vertexArray_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLsizei indexCount_ = 0;
};

}  // namespace relievo::viewer
