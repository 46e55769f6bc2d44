// Relaxed cones that are guaranteed on the bilinear surface against those of the thesis (over the
// maxima of height alone) and of Policarpo and Oliveira. What a search is worth that ran out of
// steps is what it shows: its last point counts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"
#include "viewer/reference_frame.h"

namespace relievo::viewer {
namespace {

constexpr int kMapSize = 64;
constexpr int kFrameSize = 64;

struct Errors {
    double mean = 0.0;    // texels
    double missed = 0.0;  // share of the rays that end over a texel from the first hit
    double ranOut = 0.0;
    double behind = 0.0;  // share that ends over a texel behind it

    void add(const Errors& other, double weight) {
        mean += weight * other.mean;
        missed += weight * other.missed;
        ranOut += weight * other.ranOut;
        behind += weight * other.behind;
    }
};

Errors errorsOf(RayScene& scene, int steps) {
    materials::ReliefMaterial material =
        scene.renderer.makeMaterial(materials::findTechnique("relaxed"));
    material.setParameter("cone-steps", steps);
    material.setParameter("binary-steps", 8);
    const MeasuredFrame frame =
        scene.renderer.measure(material, scene.view, kFrameSize, kFrameSize);
    const auto scale = static_cast<double>(scene.view.depthScale);
    const ReferenceFrame exact =
        traceReference(frame, scene.renderer.depthMap(), scene.view.window, scale);
    Errors errors;
    const double share = 1.0 / static_cast<double>(frame.pixels.size());
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
        const MeasuredPixel& pixel = frame.pixels[k];
        EXPECT_TRUE(pixel.covered && exact.pixels[k].hit);
        const double texels = kMapSize * (static_cast<double>(pixel.t) - exact.pixels[k].t) *
                              std::hypot(static_cast<double>(pixel.direction.x),
                                         static_cast<double>(pixel.direction.y),
                                         scale * static_cast<double>(pixel.direction.z));
        errors.add(
            {std::abs(texels), std::abs(texels) > 1.0 ? 1.0 : 0.0,
             pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED ? 1.0 : 0.0, texels > 1.0 ? 1.0 : 0.0},
            share);
    }
    return errors;
}

textures::MapSet bakeCones(const textures::SampleRelief& sample, const char* method) {
    preprocess::ReliefPlan plan;
    plan.cone = "relaxed";
    plan.method = method;
    return preprocess::bakeRelief(textures::generateSampleRelief(sample.name, kMapSize, kMapSize),
                                  plan);
}

constexpr const char* kMethods[] = {"exact", "maxima", "policarpo"};
constexpr float kElevations[] = {45.0f, 15.0f, 5.0f};
constexpr int kSteps[] = {15, 512};

// Means over all samples, of a method, elevation and number of steps.
using Table = Errors[std::size(kMethods)][std::size(kElevations)][std::size(kSteps)];

void measure(Table& table) {
    const double share = 1.0 / static_cast<double>(textures::sampleReliefs().size());
    for (const textures::SampleRelief& sample : textures::sampleReliefs())
        for (std::size_t m = 0; m < std::size(kMethods); ++m) {
            RayScene scene(bakeCones(sample, kMethods[m]), 30.0f, 90.0f);
            for (std::size_t e = 0; e < std::size(kElevations); ++e) {
                scene.look(30.0f, kElevations[e]);
                for (std::size_t s = 0; s < std::size(kSteps); ++s)
                    table[m][e][s].add(errorsOf(scene, kSteps[s]), share);
            }
        }
}

void print(const Table& table) {
    for (std::size_t s = 0; s < std::size(kSteps); ++s)
        for (std::size_t e = 0; e < std::size(kElevations); ++e)
            for (std::size_t m = 0; m < std::size(kMethods); ++m) {
                const Errors& errors = table[m][e][s];
                fmt::print(
                    "{:3} steps {:3.0f}° {:9}: mean {:8.4f} texels  missed {:7.3f} %  "
                    "ran out {:7.3f} %  behind {:7.3f} %\n",
                    kSteps[s], kElevations[e], kMethods[m], errors.mean, 100 * errors.missed,
                    100 * errors.ranOut, 100 * errors.behind);
            }
}

TEST(RelaxedCones, NeverLeadBehindAndBeatTheBaselinesWithEnoughSteps) {
    const std::unique_ptr<gl::Context> context = makeTestContext();
    Table table;
    measure(table);
    print(table);
    for (std::size_t e = 0; e < std::size(kElevations); ++e)
        for (std::size_t m = 1; m < std::size(kMethods); ++m) {
            SCOPED_TRACE(fmt::format("{} from {}°", kMethods[m], kElevations[e]));
            for (std::size_t s = 0; s < std::size(kSteps); ++s)
                EXPECT_LT(table[0][e][s].behind, table[m][e][s].behind);
            EXPECT_LT(table[0][e][1].mean, table[m][e][1].mean);
            EXPECT_LT(table[0][e][1].missed, table[m][e][1].missed);
        }
}

}  // namespace
}  // namespace relievo::viewer
