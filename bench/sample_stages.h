#pragma once

#include <map>
#include <optional>
#include <string>

#include "gl/framebuffer.h"
#include "materials/relief_material.h"
#include "materials/shadow_registry.h"
#include "materials/technique_registry.h"
#include "surfaces/surface_mesh.h"
#include "textures/depth_map.h"
#include "viewer/scene_renderer.h"

namespace relievo::bench {

/// A relief on the GPU, with the maps of some techniques, and what its frames are drawn to: 8-bit
/// colours.
struct SampleStage {
    viewer::SceneRenderer renderer;
    gl::Framebuffer target;
};

/// How a sample relief is shown.
struct StageSetting {
    int size = 256;   ///< the relief is size×size texels
    int width = 301;  ///< of the frames, in pixels
    int height = 301;
    surfaces::Tiles tiles{1.0f};  ///< on a quad
    /// Where slopes come from, whose map is baked as well; none: from the map of derivatives.
    std::optional<materials::SlopeSource> slopes = {};
};

/// The least time in seconds of `repeat` ≥ 1 shaded frames, drawn to the stage's target.
double frameSeconds(SampleStage& stage, materials::ReliefMaterial& material,
                    const viewer::View& view, int repeat);

/// A sample relief with the maps of every technique that asks for it: those that need the same maps
/// share a stage. Needs a current context for its whole life.
class SampleStages {
  public:
    /// `sample` is one of textures::sampleReliefs.
    SampleStages(const std::string& sample, const StageSetting& setting);

    /// The stage for `technique` and the shadow method, if there is one; bakes their maps when they
    /// are the first that need them.
    SampleStage& of(const materials::Technique& technique,
                    const materials::ShadowMethod* shadow = nullptr);

  private:
    std::string name_;
    StageSetting setting_;
    textures::DepthMap relief_;
    std::map<std::string, SampleStage> stages_;
};

}  // namespace relievo::bench
