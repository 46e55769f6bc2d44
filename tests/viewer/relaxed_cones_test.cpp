// Relaxed cones that are guaranteed on the bilinear surface, searched cell by cell, against those
// of the thesis (over the maxima of height alone) and of Policarpo and Oliveira, searched as
// published and cell by cell as well. What a search is worth that ran out of steps is what it
// shows: its last point counts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

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

Errors errorsOf(RayScene& scene, const char* technique, int steps) {
    materials::ReliefMaterial material =
        scene.renderer.makeMaterial(materials::findTechnique(technique));
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

textures::MapSet bakeSectors(textures::WrapMode wrap, int sectors) {
    textures::DepthMap map = textures::generateSampleRelief("cobbles", kMapSize, kMapSize);
    map.wrap = wrap;
    preprocess::ReliefPlan plan;
    plan.cone = "relaxed";
    plan.sectors = sectors;
    return preprocess::bakeRelief(std::move(map), plan);
}

constexpr const char* kMethods[] = {"exact", "maxima", "policarpo"};
constexpr const char* kTechniques[] = {"relaxed", "relaxed-step"};
constexpr float kElevations[] = {45.0f, 15.0f, 5.0f};
constexpr int kFew = 15;
constexpr int kConverged = 512;

// Means over all samples, of (method, technique, elevation, steps).
using Key = std::tuple<std::string, std::string, float, int>;
using Table = std::map<Key, Errors>;

Table measure() {
    const double share = 1.0 / static_cast<double>(textures::sampleReliefs().size());
    Table table;
    for (const textures::SampleRelief& sample : textures::sampleReliefs())
        for (const char* method : kMethods) {
            RayScene scene(bakeCones(sample, method), 30.0f, 90.0f);
            for (const float elevation : kElevations) {
                scene.look(30.0f, elevation);
                for (const char* technique : kTechniques)
                    for (const int steps : {kFew, kConverged})
                        table[{method, technique, elevation, steps}].add(
                            errorsOf(scene, technique, steps), share);
            }
        }
    return table;
}

void print(const Table& table) {
    for (const auto& [key, errors] : table) {
        const auto& [method, technique, elevation, steps] = key;
        fmt::print(
            "{:9} {:12} {:3.0f}° {:3} steps: mean {:8.4f} texels  missed {:7.3f} %  "
            "ran out {:7.3f} %  behind {:7.3f} %\n",
            method, technique, elevation, steps, errors.mean, 100 * errors.missed,
            100 * errors.ranOut, 100 * errors.behind);
    }
}

class RelaxedCones : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        const std::unique_ptr<gl::Context> context = makeTestContext();
        table_ = measure();
        print(table_);
    }
    static const Errors& ours(float elevation, int steps) {
        return table_.at({"exact", "relaxed", elevation, steps});
    }
    static Table table_;
};

Table RelaxedCones::table_;

// With as many steps as it takes the guaranteed cones are nearer, whichever way the others are
// searched.
TEST_F(RelaxedCones, RunToConvergenceBeatTheBaselines) {
    for (const auto& [key, errors] : table_) {
        const auto& [method, technique, elevation, steps] = key;
        if (method == "exact")
            continue;
        SCOPED_TRACE(fmt::format("{} of {} from {}°", technique, method, elevation));
        EXPECT_LT(ours(elevation, steps).behind, errors.behind);
        if (steps == kConverged) {
            EXPECT_LT(ours(elevation, steps).mean, errors.mean);
            EXPECT_LT(ours(elevation, steps).missed, errors.missed);
        }
    }
}

// With 15 cones and 8 halvings as well, as published and searched cell by cell.
TEST_F(RelaxedCones, WithFewStepsBeatTheBaselines) {
    for (const auto& [key, errors] : table_) {
        const auto& [method, technique, elevation, steps] = key;
        if (method == "exact" || steps != kFew)
            continue;
        SCOPED_TRACE(fmt::format("{} of {} from {}°", technique, method, elevation));
        EXPECT_LT(ours(elevation, kFew).mean, errors.mean);
        EXPECT_LT(ours(elevation, kFew).missed, errors.missed);
    }
}

// Rays of all sectors, over tiles that are mirrored and repeated: no search gets behind the first
// hit.
TEST_F(RelaxedCones, OfSectorsNeverLeadBehindTheFirstHit) {
    const std::unique_ptr<gl::Context> context = makeTestContext();
    for (const textures::WrapMode wrap :
         {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp})
        for (const int sectors : {1, 4, 8}) {
            RayScene scene(bakeSectors(wrap, sectors), 0.0f, 90.0f);
            for (int azimuth = 0; azimuth < 360; azimuth += 36) {
                scene.look(static_cast<float>(azimuth), 5.0f);
                EXPECT_EQ(errorsOf(scene, "relaxed", kConverged).missed, 0.0)
                    << wrapModeName(wrap) << " " << sectors << " " << azimuth;
            }
        }
}

// The wrong variant: cones that stand in the order of the opposite sectors.
TEST_F(RelaxedCones, OfTheWrongSectorsLeadBehindTheFirstHit) {
    const std::unique_ptr<gl::Context> context = makeTestContext();
    textures::MapSet maps = bakeSectors(textures::WrapMode::Mirror, 8);
    for (textures::Channel& channel : maps.channels)
        if (channel.name.starts_with("cone"))
            channel.name = fmt::format("cone{}", (channel.name.back() - '0') ^ 3);
    RayScene scene(std::move(maps), 30.0f, 5.0f);
    EXPECT_GT(errorsOf(scene, "relaxed", kConverged).behind, 0.001);
}

}  // namespace
}  // namespace relievo::viewer
