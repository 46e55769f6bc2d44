#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/framebuffer.h"
#include "materials/relief_maps.h"
#include "materials/relief_material.h"
#include "materials/surface_textures.h"
#include "surfaces/surface_mesh.h"
#include "textures/map_set.h"
#include "viewer/frame_renderer.h"
#include "viewer/measured_frame.h"
#include "viewer/reference_frame.h"

namespace relievo::viewer {

/// What is seen of one relief, apart from the technique that shows it.
struct View : FrameView {
    float depthScale = 0.1f;       ///< a, in tile widths
    glm::vec4 window{0, 0, 1, 1};  ///< minimum u, v, maximum u, v of the relief
    /// Where slopes come from; none: the best source that the relief has. A source that it lacks is
    /// refused with textures::InputError when something is drawn.
    std::optional<materials::SlopeSource> slopes;
    materials::Shading shading;
};

/// A relief on a surface, drawn with any technique: the frame of one object. Needs a current
/// context for its whole life; it draws to framebuffer objects only, so that a window and a
/// headless run share every step.
class SceneRenderer {
  public:
    /// `name` stands for the relief in error messages. Without an albedo the relief is grey.
    SceneRenderer(textures::MapSet maps, const std::string& name, materials::TextureSet textures);
    /// With the MIP levels of the relief, the first one first.
    SceneRenderer(std::vector<textures::MapSet> levels, const std::string& name,
                  materials::TextureSet textures);

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
    /// How many MIP levels the relief has, the first one counted.
    [[nodiscard]] int levelCount() const noexcept { return reliefMaps_->levelCount(); }

  private:
    /// The surface made of `material`, which takes what the view says of it.
    SceneObject objectIn(const View& view, materials::ReliefMaterial& material);

    textures::DepthMap depthMap_;
    std::shared_ptr<materials::ReliefMaps> reliefMaps_;
    materials::SurfaceTextures textures_;
    FrameRenderer frames_;
    std::optional<SurfaceBuffers> surface_;
};

}  // namespace relievo::viewer
