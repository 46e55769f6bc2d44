// Searches in the MIP levels of a relief: each level is a relief of its own, found as exactly as
// any, and a pixel takes the one of its size.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "bench/technique_maps.h"
#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "surfaces/surface_mesh.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

// The levels of a pyramid are something else, so that its searches stay in the first one. `auto`
// knows the range of depths of the first level, and `alone` below has one of its own.
bool isComparable(const materials::Technique& technique) {
    return std::ranges::find(technique.maps, "pyramid") == technique.maps.end() &&
           technique.name != "auto";
}

std::vector<textures::MapSet> bakeChain(const textures::DepthMap& map,
                                        preprocess::ReliefPlan plan) {
    plan.mips = true;
    return preprocess::bakeLevels(map, plan);
}

textures::DepthMap sampleOf(std::string_view name, int width, int height,
                            textures::WrapMode wrap = textures::WrapMode::Repeat) {
    textures::DepthMap map = textures::generateSampleRelief(name, width, height);
    map.wrap = wrap;
    return map;
}

// A relief with levels under parallel rays, without a window.
struct LevelScene {
    SceneRenderer renderer;
    View view;

    LevelScene(std::vector<textures::MapSet> levels, float azimuth, float elevation)
        : renderer(std::move(levels), "test", {}) {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        const auto aspect = static_cast<float>(renderer.depthMap().aspect());
        renderer.setSurface(surfaces::makeQuad({1, 1}, aspect));
        view.camera = parallelRays(azimuth, elevation, aspect);
        view.window = {-kInfinity, -kInfinity, kInfinity, kInfinity};
    }

    // All pixels in one level, or each in that of its size.
    MeasuredFrame measure(const materials::Technique& technique, int size,
                          std::optional<int> level = {}) {
        materials::ReliefMaterial material = renderer.makeMaterial(technique);
        if (level)
            material.levels = glm::vec2(static_cast<float>(*level));
        return renderer.measure(material, view, size, size);
    }
};

std::size_t differences(const MeasuredFrame& a, const MeasuredFrame& b) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k)
        count += a.pixels[k].t == b.pixels[k].t && a.pixels[k].hit == b.pixels[k].hit &&
                         a.pixels[k].outcome == b.pixels[k].outcome &&
                         a.pixels[k].normal == b.pixels[k].normal
                     ? 0
                     : 1;
    return count;
}

class MipLevels : public testing::Test {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// In sizes that are powers of two a level has square texels, so that it can be a file of its own:
// with it the search does the same.
TEST_F(MipLevels, AreSearchedLikeReliefsOfTheirOwn) {
    for (const materials::Technique* technique : everyTechnique()) {
        if (!isComparable(*technique))
            continue;
        SCOPED_TRACE(std::string(technique->name));
        const auto levels = bakeChain(sampleOf("cobbles", 32, 16), bench::planFor(*technique));
        LevelScene chain(levels, 30.0f, 15.0f);
        const MeasuredFrame first = chain.measure(*technique, 24, 0);
        for (const int level : {1, 2}) {
            LevelScene alone({levels[static_cast<std::size_t>(level)]}, 30.0f, 15.0f);
            const MeasuredFrame frame = chain.measure(*technique, 24, level);
            EXPECT_EQ(differences(frame, alone.measure(*technique, 24)), 0u) << "level " << level;
            EXPECT_GT(differences(frame, first), 100u)
                << "level " << level << " is not searched at all";
        }
    }
}

// Levels of odd sizes have texels that are no squares; the truth knows them.
TEST_F(MipLevels, HaveExactHitsWhateverTheShapeOfTheirTexels) {
    const materials::Technique& exact = materials::findTechnique("exact");
    for (const textures::WrapMode wrap :
         {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp})
        for (const int sectors : {4, 8}) {
            preprocess::ReliefPlan plan = bench::planFor(exact);
            plan.sectors = sectors;
            const auto levels = bakeChain(sampleOf("lettering", 61, 37, wrap), plan);
            for (const int level : {1, 2, 3, 5})
                for (const float azimuth : {30.0f, 200.0f}) {
                    LevelScene scene(levels, azimuth, 10.0f);
                    const MeasuredFrame frame = scene.measure(exact, 32, level);
                    const textures::DepthMap map =
                        textures::depthMapOf(levels[static_cast<std::size_t>(level)]);
                    EXPECT_NE(map.texelAspect, 1.0);
                    const ReferenceFrame truth = traceReference(frame, map, scene.view.window, 0.1);
                    const reference::ErrorStatistics errors = reference::summarizeErrors(
                        compareFrames(frame, truth, map, 0.1), 1.0 / map.width());
                    EXPECT_EQ(errors.wrongShare, 0.0)
                        << "wrap " << static_cast<int>(wrap) << ", " << sectors
                        << " sectors, level " << level << ", azimuth " << azimuth;
                }
        }
}

// The truth of another level is not this one's.
TEST_F(MipLevels, TheTruthOfAnotherLevelIsWrong) {
    const materials::Technique& exact = materials::findTechnique("exact");
    const auto levels = bakeChain(sampleOf("lettering", 61, 37), bench::planFor(exact));
    LevelScene scene(levels, 30.0f, 10.0f);
    const MeasuredFrame frame = scene.measure(exact, 32, 2);
    const textures::DepthMap map = textures::depthMapOf(levels[1]);
    const ReferenceFrame truth = traceReference(frame, map, scene.view.window, 0.1);
    EXPECT_GT(reference::summarizeErrors(compareFrames(frame, truth, map, 0.1), 1.0 / map.width())
                  .wrongShare,
              0.05);
}

// A frame of n pixels shows one tile of 128 texels: with between 2^(k+1) and 2^(k+2) texels a
// pixel, in level k a pixel has between two and four texels.
TEST_F(MipLevels, APixelTakesTheOneOfItsSize) {
    const materials::Technique& relief = materials::findTechnique("relief");
    const auto levels = bakeChain(sampleOf("noise", 128, 128), bench::planFor(relief));
    const struct {
        int frame;
        int level;
    } kFrames[] = {{90, 0}, {45, 0}, {23, 1}, {11, 2}, {6, 3}};
    for (const auto& [frame, level] : kFrames) {
        SCOPED_TRACE(frame);
        LevelScene scene(levels, 30.0f, 45.0f);
        const MeasuredFrame chosen = scene.measure(relief, frame);
        const MeasuredFrame forced = scene.measure(relief, frame, level);
        std::size_t others = 0;
        for (std::size_t k = 0; k < chosen.pixels.size(); ++k)
            others += chosen.pixels[k].t == forced.pixels[k].t ? 0 : 1;
        EXPECT_EQ(others, 0u);
    }
}

// The pixel is measured in texels whatever the shape of the map.
TEST_F(MipLevels, AreChosenInTexelsOfLongMaps) {
    const materials::Technique& relief = materials::findTechnique("relief");
    const auto levels = bakeChain(sampleOf("noise", 128, 32), bench::planFor(relief));
    // parallelRays shows the tile in a square frame: 128/20 texels across and 32/20 down. What
    // counts is the shorter side.
    LevelScene scene(levels, 30.0f, 45.0f);
    EXPECT_EQ(differences(scene.measure(relief, 20), scene.measure(relief, 20, 0)), 0u);
    EXPECT_GT(differences(scene.measure(relief, 6), scene.measure(relief, 6, 0)), 20u);
}

TEST_F(MipLevels, WithTheFirstOneAloneThePictureIsThatWithoutLevels) {
    const materials::Technique& exact = materials::findTechnique("exact");
    const auto levels = bakeChain(sampleOf("bricks", 64, 64), bench::planFor(exact));
    LevelScene chain(levels, 30.0f, 20.0f);
    LevelScene plain({levels.front()}, 30.0f, 20.0f);
    EXPECT_EQ(differences(chain.measure(exact, 16, 0), plain.measure(exact, 16)), 0u);
    EXPECT_GT(differences(chain.measure(exact, 16), plain.measure(exact, 16)), 100u);
}

TEST_F(MipLevels, OfWrongSizesAreRefused) {
    auto levels = bakeChain(sampleOf("bricks", 16, 16), {});
    levels.erase(levels.begin() + 1);
    EXPECT_THROW(materials::ReliefMaps(levels, "x.exr"), textures::InputError);
    levels = bakeChain(sampleOf("bricks", 16, 16), {});
    levels.pop_back();
    EXPECT_THROW(materials::ReliefMaps(levels, "x.exr"), textures::InputError);
}

}  // namespace
}  // namespace relievo::viewer
