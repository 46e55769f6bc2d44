#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "solids/solid.h"
#include "viewer/camera.h"
#include "viewer/contact_sheet.h"
#include "viewer/frame_renderer.h"
#include "viewer/picture.h"
#include "viewer/solid_stage.h"

namespace relievo::bench {

/// What all figures of a sheet share. Needs a current context for its whole life.
struct FigureFrames {
    int width = 0;  ///< of each picture, in pixels
    int height = 0;
    int texels = 0;  ///< of the width of shape maps
    viewer::FrameRenderer renderer;
};

/// Rays along each side of a pixel.
inline constexpr int kFigureRays = 3;

/// A box in the world: its edges, its centre, and degrees about x, y and z.
struct BoxPlace {
    glm::dvec3 size{1.0};
    glm::dvec3 position{0.0};
    glm::dvec3 degrees{0.0};

    /// From the space of the whole of `tiles` to the world (viewer/box_placement.h).
    [[nodiscard]] glm::dmat4 fromTiles(const glm::dvec3& tiles = glm::dvec3(1.0)) const;
    [[nodiscard]] glm::dmat4 fromLocal() const;
};

/// A part that fills tiles from the origin on.
solids::SolidPart extrusionOf(std::shared_ptr<const textures::ShapeMap> shape,
                              const solids::Profile& profile = solids::makeProfile(0.0),
                              const glm::dvec2& tiles = glm::dvec2(1.0));
solids::SolidPart revolutionOf(std::shared_ptr<const textures::ShapeMap> shape,
                               const glm::dvec2& tiles = glm::dvec2(1.0));

/// The objects of a figure, from where it is seen, and its light.
class FigureStage {
  public:
    explicit FigureStage(FigureFrames& frames);

    /// Adds a part in a box of its own. Colours are linear.
    materials::SolidMaterial& addBox(const solids::SolidPart& part, const BoxPlace& place,
                                     const glm::vec3& color);
    /// Adds a part that is sunk `depth` tile widths into a mesh.
    materials::SolidMaterial& addSunk(const solids::SolidPart& part,
                                      const surfaces::SurfaceMesh& mesh, double depth,
                                      const glm::vec3& color);
    /// Adds a box without a solid.
    void addBlock(const BoxPlace& place, const glm::vec3& color);
    /// Adds the twelve edges of a box: those from the corner u = v = z = 0 are red along u, green
    /// along v and blue along z.
    void addEdges(const BoxPlace& place, double thickness);
    /// Adds a wide floor at that height.
    void addGround(double height);

    [[nodiscard]] viewer::SolidStage& stage() noexcept { return stage_; }

    /// The picture, several rays a pixel, with the shadows that the light throws if there is one.
    [[nodiscard]] viewer::Picture draw();
    /// The picture as it is without depths from the searches: one object after the other over what
    /// is there, in the order in which they were added, without the shadows.
    [[nodiscard]] viewer::Picture drawInOrder();

    viewer::OrbitCamera eye{.azimuth = 20, .elevation = 22, .distance = 3.2f, .fieldOfView = 28};
    glm::vec2 light{-50, 42};  ///< azimuth and elevation, in degrees
    bool throwsShadows = true;

  private:
    [[nodiscard]] viewer::FrameView view() const;
    [[nodiscard]] gl::Framebuffer makeTarget() const;

    FigureFrames& frames_;
    viewer::SolidStage stage_;
};

/// What a framebuffer of kFigureRays times the size holds.
viewer::Picture averagedPicture(const gl::Framebuffer& target);

}  // namespace relievo::bench
