#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gl/context.h"
#include "materials/technique_registry.h"
#include "reference/error_metrics.h"
#include "textures/map_set.h"
#include "textures/sample_reliefs.h"
#include "viewer/scene_renderer.h"

namespace relievo::viewer {

/// All maps that techniques read, built in memory: conservative cones (as radii those of texel
/// centres, which are the only ones), and roof cones.
textures::MapSet bakeMaps(const textures::DepthMap& map,
                          textures::ConeEncoding encoding = textures::ConeEncoding::Ratio);

/// The maps for one technique: those of bakeMaps, or for one that reads relaxed cones or a table of
/// displacements its own.
textures::MapSet bakeMapsFor(const materials::Technique& technique, const textures::DepthMap& map,
                             textures::ConeEncoding encoding = textures::ConeEncoding::Ratio);

/// A relief on one quad tile under parallel rays, without a window: what most image tests look at.
/// Needs a current context.
struct RayScene {
    SceneRenderer renderer;
    View view;

    RayScene(const textures::MapSet& maps, float azimuth, float elevation, float depthScale = 0.1f);

    /// Looks from elsewhere. Programs and maps stay.
    void look(float azimuth, float elevation, float depthScale = 0.1f);

    /// Errors of `technique` over a frame of size², a first hit being wrong when it is off by more
    /// than a texel. Parameters take their defaults, or those of `material`.
    reference::ErrorStatistics errors(const materials::Technique& technique, int size);
    reference::ErrorStatistics errors(materials::ReliefMaterial& material, int size);
};

/// For tests with a parameter: all entries of the registry, all sample reliefs, and what the tests
/// are called for them.
std::vector<const materials::Technique*> everyTechnique();
std::vector<const textures::SampleRelief*> everySample();
template <typename Entry>
std::string nameOfTest(const testing::TestParamInfo<const Entry*>& test) {
    std::string name(test.param->name);
    std::ranges::replace(name, '-', '_');
    return name;
}

/// An OSMesa context whose driver errors are exceptions.
std::unique_ptr<gl::Context> makeTestContext();

/// A framebuffer for a shaded picture.
gl::Framebuffer makeColorTarget(int width, int height);

}  // namespace relievo::viewer
