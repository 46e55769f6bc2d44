#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "bench/solid_truth.h"
#include "gl/framebuffer.h"
#include "materials/shape_textures.h"
#include "materials/solid_material.h"
#include "solids/solid.h"
#include "viewer/frame_renderer.h"
#include "viewer/scene_renderer.h"

namespace relievo::bench {

/// From where a solid is seen.
struct SolidSight {
    double elevation = 45.0;  ///< degrees above the plane
    double azimuth = 35.0;
    double depthScale = 0.25;  ///< of extrusions, in tile widths
    int frame = 201;           ///< pixels on a side
};

/// What a search did, and how long a shaded frame took it.
struct SolidRun {
    viewer::MeasuredFrame frame;
    double seconds = 0.0;
};

/// A solid of one part on the graphics processor. Extrusions are sunk into a square of one tile,
/// each pixel of which is a ray; revolutions stand in the box of their window, which an eye far
/// away looks at. Needs a current context for its whole life, and the renderer for it.
class SolidStage {
  public:
    SolidStage(viewer::FrameRenderer& frames, const solids::SolidPart& part);

    [[nodiscard]] SolidSpace space(const SolidSight& sight) const;
    /// Draws and measures the solid with a search, which must show it; `steps`, if there are any,
    /// are its budget.
    SolidRun run(const materials::SolidTechnique& technique, std::optional<int> steps,
                 const SolidSight& sight, int repeat);

  private:
    [[nodiscard]] bool isInBox() const;

    viewer::FrameRenderer& frames_;
    solids::SolidPart part_;
    std::shared_ptr<materials::ShapeTextureCache> shapes_;
    std::optional<glm::dmat4> boxFromWhole_;
    viewer::SurfaceBuffers surface_;
};

/// An extrusion as a relief in the same square under the same rays, with the maps of every
/// technique that asks for it. Needs a current context for its whole life.
class SolidReliefStages {
  public:
    explicit SolidReliefStages(textures::DepthMap relief) : relief_(std::move(relief)) {}

    SolidRun run(const materials::Technique& technique, std::optional<int> steps,
                 const SolidSight& sight, int repeat);

  private:
    viewer::SceneRenderer& rendererFor(const materials::Technique& technique);

    textures::DepthMap relief_;
    std::map<std::string, viewer::SceneRenderer> renderers_;
};

}  // namespace relievo::bench
