#pragma once

#include <memory>
#include <vector>

#include "gl/context.h"
#include "materials/solid_material.h"
#include "solid_samples.h"
#include "viewer/frame_renderer.h"
#include "viewer/surface_buffers.h"

namespace relievo::viewer {

/// What solids are drawn with, one after the other: programs and shapes stay.
struct SolidStage {
    std::unique_ptr<gl::Context> context;
    std::shared_ptr<materials::ShapeTextureCache> shapes;
    std::unique_ptr<FrameRenderer> frames;

    SolidStage();
    ~SolidStage();
};

/// A solid alone in the world: sunk into a quad of one tile, or in its box, whose middle is the
/// origin.
class SolidScene {
  public:
    SolidScene(SolidStage& stage, const SolidCase& solidCase);

    /// What each pixel of a frame of size² found, and the ray that it was given.
    MeasuredFrame measure(const Camera& camera, int size);

    /// Views from elevations of 90° down to 0.1° around the solid; of a box also level ones, from
    /// below, and from eyes within it.
    [[nodiscard]] std::vector<Camera> cameras() const;

    materials::SolidMaterial material;

  private:
    SolidStage& stage_;
    SolidCase case_;
    std::unique_ptr<SurfaceBuffers> surface_;
};

}  // namespace relievo::viewer
