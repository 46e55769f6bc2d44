// Every technique against the exact first hits, on every sample relief, from straight above to
// grazing. The table that it prints is the record of what each technique is worth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "materials/technique_registry.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

constexpr int kMapSize = 128;
constexpr int kFrameSize = 64;
// Largest share of wrong first hits that cone tracing may have on any of the frames below: 4 of
// their 4096 pixels, rays that graze a crest closer than the tolerance.
constexpr double kConeBudget = 0.001;
constexpr float kElevations[] = {90.0f, 45.0f, 15.0f, 5.0f};

class TechniqueErrors : public testing::TestWithParam<const textures::SampleRelief*> {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

void print(std::string_view sample, float elevation, const materials::Technique& technique,
           const reference::ErrorStatistics& errors) {
    fmt::print(
        "{:12} {:3.0f}° {:8} wrong {:7.3f} %  ran out {:6.3f} %  mean {:8.4f}  max {:8.2f} "
        "texels\n",
        sample, elevation, technique.name, 100 * errors.wrongShare, 100 * errors.unconvergedShare,
        errors.meanDistance * kMapSize, errors.maximumDistance * kMapSize);
}

// Cone tracing run to convergence: it misses first hits only where a cone of texel centres is too
// wide between the centres (specification 3.2), so seldom, and never gives up. Linear search with
// the same freedom of direction steps over features; relief mapping inherits that.
TEST_P(TechniqueErrors, ConeTracingConvergesToTheFirstHit) {
    const textures::DepthMap map =
        textures::generateSampleRelief(GetParam()->name, kMapSize, kMapSize);
    for (const float elevation : kElevations) {
        RayScene scene(bakeMaps(map), 30.0f, elevation);
        for (const char* name : {"linear", "relief", "cone", "exact"}) {
            const materials::Technique& technique = materials::findTechnique(name);
            const reference::ErrorStatistics errors = scene.errors(technique, kFrameSize);
            print(GetParam()->name, elevation, technique, errors);
            if (technique.name == std::string_view("cone")) {
                EXPECT_EQ(errors.unconvergedShare, 0.0) << elevation;
                EXPECT_LT(errors.wrongShare, kConeBudget) << elevation;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, TechniqueErrors, testing::ValuesIn([] {
                             std::vector<const textures::SampleRelief*> samples;
                             for (const auto& sample : textures::sampleReliefs())
                                 samples.push_back(&sample);
                             return samples;
                         }()),
                         [](const auto& test) { return std::string(test.param->name); });

// The budget is one that cones of twice the width do not meet on a relief with cliffs.
TEST(TooWideCones, AreCaught) {
    const std::unique_ptr<gl::Context> context = makeTestContext();
    textures::MapSet maps =
        bakeMaps(textures::generateSampleRelief("lettering", kMapSize, kMapSize));
    for (textures::Channel& channel : maps.channels)
        if (channel.name == "cone")
            for (float& ratio : channel.plane.texels)
                ratio *= 2;
    RayScene scene(maps, 30.0f, 5.0f);
    EXPECT_GT(scene.errors(materials::findTechnique("cone"), kFrameSize).wrongShare,
              10 * kConeBudget);
}

}  // namespace
}  // namespace relievo::viewer
