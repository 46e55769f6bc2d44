// The techniques `exact`, `pyramid` and `cone` against the double-precision tracer: no wrong first
// hit beyond what the rounding of floats explains, on every sample relief, under every wrap mode,
// from straight above down to a tenth of a degree.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstdlib>
#include <string>

#include "bench/technique_maps.h"
#include "float_rounding.h"
#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

constexpr const char* kExactTechniques[] = {"exact", "pyramid", "cone"};
constexpr int kMostSteps = 16384;  // at 0.1° rays between pillars cross thousands of cones
constexpr float kElevations[] = {90.0f, 45.0f, 15.0f, 5.0f, 1.0f, 0.1f};
constexpr float kAzimuths[] = {0.0f, 30.0f, 135.0f, 261.0f};

int frameSize() {
    const char* const size = std::getenv("RELIEVO_FRAME_SIZE");
    return size == nullptr ? 48 : std::stoi(size);
}

textures::MapSet bakeRoofs(const textures::DepthMap& map, int sectors) {
    preprocess::ReliefPlan plan;
    plan.cone = "roof";
    plan.sectors = sectors;
    return preprocess::bakeRelief(map, plan);
}

textures::MapSet bakeFor(const char* technique, const textures::DepthMap& map) {
    return preprocess::bakeRelief(map, bench::planFor(materials::findTechnique(technique)));
}

struct Tally {
    std::size_t rays = 0;
    std::size_t wrong = 0;
    double fetches = 0.0;
};

Tally tally(const textures::MapSet& maps, const char* technique) {
    SCOPED_TRACE(technique);
    const textures::DepthMap map = textures::depthMapOf(maps);
    const FloatRounding rounding(map);
    RayScene scene(maps, 0.0f, 90.0f);
    materials::ReliefMaterial material =
        scene.renderer.makeMaterial(materials::findTechnique(technique));
    material.setParameter(materials::budgetParameter(material.technique())->name, kMostSteps);
    Tally result;
    for (const float elevation : kElevations)
        for (const float azimuth : kAzimuths) {
            scene.look(azimuth, elevation);
            const MeasuredFrame frame =
                scene.renderer.measure(material, scene.view, frameSize(), frameSize());
            std::atomic<std::size_t> wrong = 0;
            tbb::parallel_for(std::size_t{0}, frame.pixels.size(), [&](std::size_t k) {
                if (!rounding.explains(frame.pixels[k]))
                    ++wrong;
            });
            const WorkCounts work = countWork(frame);
            EXPECT_EQ(work.pixels, frame.pixels.size());
            EXPECT_EQ(wrong, 0u) << "elevation " << elevation << ", azimuth " << azimuth;
            result.rays += work.pixels;
            result.wrong += wrong;
            result.fetches += work.meanFetches * static_cast<double>(work.pixels);
        }
    return result;
}

textures::DepthMap sampleRelief(std::string_view name, int width, int height,
                                textures::WrapMode wrap) {
    textures::DepthMap map = textures::generateSampleRelief(name, width, height);
    map.wrap = wrap;
    return map;
}

class ExactHits : public testing::TestWithParam<const textures::SampleRelief*> {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

TEST_P(ExactHits, AreTheFirstOnesUnderEveryWrapMode) {
    for (const textures::WrapMode wrap :
         {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp}) {
        SCOPED_TRACE(testing::Message() << "wrap " << static_cast<int>(wrap));
        const textures::DepthMap map = sampleRelief(GetParam()->name, 128, 128, wrap);
        for (const char* technique : kExactTechniques) {
            const Tally found = tally(bakeFor(technique, map), technique);
            fmt::print("{:12} wrap {} {:8} {} rays, {} wrong, {:.1f} fetches a ray\n",
                       GetParam()->name, static_cast<int>(wrap), technique, found.rays, found.wrong,
                       found.fetches / static_cast<double>(found.rays));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, ExactHits, testing::ValuesIn(everySample()),
                         nameOfTest<textures::SampleRelief>);

class ExactHitsOf : public testing::Test {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

TEST_F(ExactHitsOf, EveryNumberOfSectorsAndShapeOfMap) {
    for (const textures::WrapMode wrap :
         {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp})
        for (const int sectors : {1, 4, 8})
            for (const auto& [width, height] : {std::pair(61, 37), std::pair(16, 128)}) {
                SCOPED_TRACE(testing::Message()
                             << "wrap " << static_cast<int>(wrap) << ", " << sectors << " sectors, "
                             << width << "×" << height);
                const textures::MapSet maps =
                    bakeRoofs(sampleRelief("lettering", width, height, wrap), sectors);
                tally(maps, "exact");
                if (sectors == 1)
                    tally(maps, "pyramid");
            }
}

TEST_F(ExactHitsOf, MapsOfOneTexelOrOneRow) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 16), std::pair(16, 1)})
        for (const textures::WrapMode wrap :
             {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp}) {
            SCOPED_TRACE(testing::Message()
                         << width << "×" << height << ", wrap " << static_cast<int>(wrap));
            for (const char* technique : kExactTechniques)
                tally(bakeFor(technique, sampleRelief("noise", width, height, wrap)), technique);
        }
}

// Cones half as wide again, and roofs a little too deep, are found out.
TEST_F(ExactHitsOf, UnsafeMapsAreWrong) {
    const textures::DepthMap map = sampleRelief("lettering", 128, 128, textures::WrapMode::Repeat);
    for (const std::string channel : {"ratio", "roof"}) {
        textures::MapSet maps = bakeRoofs(map, 4);
        for (textures::Channel& plane : maps.channels)
            if (plane.name.starts_with(channel))
                for (float& value : plane.plane.texels)
                    value = channel == "roof" ? value + 0.05f : 1.5f * value;
        const FloatRounding rounding(map);
        RayScene scene(maps, 30.0f, 5.0f);
        materials::ReliefMaterial material =
            scene.renderer.makeMaterial(materials::findTechnique("exact"));
        const MeasuredFrame frame = scene.renderer.measure(material, scene.view, 48, 48);
        std::size_t wrong = 0;
        for (const MeasuredPixel& pixel : frame.pixels)
            wrong += rounding.explains(pixel) ? 0 : 1;
        EXPECT_GT(wrong, frame.pixels.size() / 100) << channel;
    }
}

}  // namespace
}  // namespace relievo::viewer
