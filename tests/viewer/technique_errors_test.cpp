// Every technique against the exact first hits, on every sample relief, from straight above to
// grazing. The table that it prints is the record of what each technique is worth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bench/technique_maps.h"
#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

constexpr int kMapSize = 128;
constexpr int kFrameSize = 64;
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

// Guaranteed cones never lead past the first hit, and cells are solved: no hit is wrong. Linear
// search with the same freedom of direction steps over features; relief mapping inherits that.
TEST_P(TechniqueErrors, ConeTracingFindsTheFirstHit) {
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
                EXPECT_EQ(errors.wrongShare, 0.0) << elevation;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, TechniqueErrors, testing::ValuesIn(everySample()),
                         nameOfTest<textures::SampleRelief>);

class Budgets : public testing::TestWithParam<const materials::Technique*> {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// The worst of what was measured must be near the budget: a loose one would let a technique get
// worse unseen. Below these numbers a budget says that there is nothing to see.
constexpr double kLeastPercent = 0.05;
constexpr double kLeastTexels = 1e-4;

void expectTight(double worst, double budget, double least, const char* what) {
    EXPECT_LE(worst, budget) << what;
    EXPECT_GE(std::max(worst, least), 0.9 * budget) << what << ": the budget is loose";
}

TEST_P(Budgets, HoldOnEverySample) {
    const materials::Technique& technique = *GetParam();
    const struct {
        float elevation;
        materials::ErrorBudget::At budget;
    } views[] = {{45.0f, technique.errors.at45}, {15.0f, technique.errors.at15}};
    materials::ErrorBudget::At worst[] = {{0.0, 0.0}, {0.0, 0.0}};
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        SCOPED_TRACE(std::string(sample.name));
        RayScene scene(
            preprocess::bakeRelief(textures::generateSampleRelief(sample.name, kMapSize, kMapSize),
                                   bench::planFor(technique)),
            30.0f, 90.0f);
        for (std::size_t k = 0; k < std::size(views); ++k) {
            scene.look(30.0f, views[k].elevation);
            const reference::ErrorStatistics errors = scene.errors(technique, kFrameSize);
            const double wrong = 100 * errors.wrongShare;
            const double mean = errors.meanDistance * kMapSize;
            EXPECT_LE(wrong, views[k].budget.wrongPercent) << views[k].elevation;
            EXPECT_LE(mean, views[k].budget.meanTexels) << views[k].elevation;
            worst[k] = {std::max(worst[k].wrongPercent, wrong),
                        std::max(worst[k].meanTexels, mean)};
        }
    }
    fmt::print("{}: {{{{{:.4g}, {:.4g}}}, {{{:.4g}, {:.4g}}}}}\n", technique.name,
               worst[0].wrongPercent, worst[0].meanTexels, worst[1].wrongPercent,
               worst[1].meanTexels);
    for (std::size_t k = 0; k < std::size(views); ++k) {
        SCOPED_TRACE(views[k].elevation);
        expectTight(worst[k].wrongPercent, views[k].budget.wrongPercent, kLeastPercent, "wrong %");
        expectTight(worst[k].meanTexels, views[k].budget.meanTexels, kLeastTexels, "mean texels");
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, Budgets, testing::ValuesIn(everyTechnique()),
                         nameOfTest<materials::Technique>);

class GuaranteedCones : public Budgets {};

// With the maps that relievo-bake makes by default no step leads past the first hit by over a
// texel.
TEST_P(GuaranteedCones, NeverOvershoot) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        RayScene scene(
            preprocess::bakeRelief(textures::generateSampleRelief(sample.name, kMapSize, kMapSize),
                                   bench::planFor(*GetParam())),
            30.0f, 90.0f);
        for (const float elevation : {90.0f, 45.0f, 15.0f, 5.0f, 1.0f}) {
            scene.look(30.0f, elevation);
            EXPECT_EQ(scene.errors(*GetParam(), kFrameSize).overshotShare, 0.0)
                << sample.name << " from " << elevation << "°";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, GuaranteedCones,
                         testing::Values(&materials::findTechnique("cone"),
                                         &materials::findTechnique("relaxed")),
                         nameOfTest<materials::Technique>);

// Cones of twice the width lead past hits on a relief with cliffs.
TEST(TooWideCones, AreCaught) {
    const std::unique_ptr<gl::Context> context = makeTestContext();
    textures::MapSet maps =
        bakeMaps(textures::generateSampleRelief("lettering", kMapSize, kMapSize));
    for (textures::Channel& channel : maps.channels)
        if (channel.name == "cone")
            for (float& ratio : channel.plane.texels)
                ratio *= 2;
    RayScene scene(maps, 30.0f, 5.0f);
    EXPECT_GT(scene.errors(materials::findTechnique("cone"), kFrameSize).wrongShare, 0.01);
}

}  // namespace
}  // namespace relievo::viewer
