// Every method of self-shadowing against the exact visibility, on every sample relief, under lights
// that are points and discs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "bench/technique_maps.h"
#include "materials/shadow_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"
#include "viewer/light_errors.h"

namespace relievo::viewer {
namespace {

constexpr int kMapSize = 128;
constexpr int kFrameSize = 64;
constexpr int kLightRays = 128;
constexpr float kDisc = 10.0f;  // degrees

struct Light {
    float elevation;
    float size;  // degrees across
};

// The relief from 60° with a light.
class LitScene {
  public:
    LitScene(const textures::DepthMap& map, const preprocess::ReliefPlan& plan)
        : scene_(preprocess::bakeRelief(map, plan), 30.0f, 60.0f) {}

    void light(const Light& light, float azimuth = -50.0f) {
        scene_.view.toLight = directionTowards(azimuth, light.elevation);
        scene_.view.lightRadius = glm::radians(light.size / 2.0f);
        scene_.view.lightRays = kLightRays;
        exact_ = scene_.renderer.trace(scene_.view, kFrameSize, kFrameSize);
    }

    MeasuredFrame measure(const materials::Technique& technique,
                          const materials::ShadowMethod* method) {
        materials::ReliefMaterial material = scene_.renderer.makeMaterial(technique);
        material.setShadow(method);
        return scene_.renderer.measure(material, scene_.view, kFrameSize, kFrameSize);
    }

    LightErrors errors(const materials::Technique& technique,
                       const materials::ShadowMethod* method) {
        return summarizeLight(measure(technique, method), exact_);
    }

    [[nodiscard]] const ReferenceFrame& exact() const { return exact_; }
    RayScene& scene() { return scene_; }

  private:
    RayScene scene_;
    ReferenceFrame exact_;
};

textures::DepthMap sampleMap(std::string_view name,
                             textures::WrapMode wrap = textures::WrapMode::Repeat) {
    textures::DepthMap map = textures::generateSampleRelief(name, kMapSize, kMapSize);
    map.wrap = wrap;
    return map;
}

std::vector<const materials::ShadowMethod*> everyMethod() {
    std::vector<const materials::ShadowMethod*> methods;
    for (const materials::ShadowMethod& method : materials::shadowMethods())
        methods.push_back(&method);
    return methods;
}

const materials::Technique& exactTechnique() {
    return materials::findTechnique("exact");
}

class ShadowBudgets : public testing::TestWithParam<const materials::ShadowMethod*> {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// A loose budget would let a method get worse unseen. Below this one there is nothing to see.
constexpr double kLeastPercent = 0.05;

void expectTight(double worst, double budget) {
    EXPECT_LE(worst, budget);
    EXPECT_GE(std::max(worst, kLeastPercent), 0.9 * budget) << "the budget is loose";
}

TEST_P(ShadowBudgets, HoldOnEverySample) {
    const materials::ShadowMethod& method = *GetParam();
    const struct {
        Light light;
        double budget;
    } cases[] = {{{45.0f, 0.0f}, method.errors.at45.pointPercent},
                 {{45.0f, kDisc}, method.errors.at45.discPercent},
                 {{15.0f, 0.0f}, method.errors.at15.pointPercent},
                 {{15.0f, kDisc}, method.errors.at15.discPercent}};
    double worst[std::size(cases)] = {};
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        SCOPED_TRACE(std::string(sample.name));
        LitScene scene(sampleMap(sample.name), bench::planFor(exactTechnique(), &method));
        for (std::size_t k = 0; k < std::size(cases); ++k) {
            scene.light(cases[k].light);
            const LightErrors errors = scene.errors(exactTechnique(), &method);
            EXPECT_GT(errors.pixels, kFrameSize * kFrameSize / 2u);
            fmt::print(
                "{:8} {:12} {:2.0f}° {:2.0f}°: {:7.3f} % wrong, mean {:.4f}, {:.1f} fetches\n",
                method.name, sample.name, cases[k].light.elevation, cases[k].light.size,
                100 * errors.wrongShare, errors.meanError, errors.meanFetches);
            worst[k] = std::max(worst[k], 100 * errors.wrongShare);
        }
    }
    fmt::print("{}: {{{{{:.4g}, {:.4g}}}, {{{:.4g}, {:.4g}}}}}\n", method.name, worst[0], worst[1],
               worst[2], worst[3]);
    for (std::size_t k = 0; k < std::size(cases); ++k) {
        SCOPED_TRACE(testing::Message()
                     << cases[k].light.elevation << "°, " << cases[k].light.size);
        expectTight(worst[k], cases[k].budget);
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, ShadowBudgets, testing::ValuesIn(everyMethod()),
                         nameOfTest<materials::ShadowMethod>);

class Shadows : public testing::Test {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

TEST_F(Shadows, NoneIsWrongOnAReliefWithShadows) {
    LitScene scene(sampleMap("blocks"), bench::planFor(exactTechnique()));
    scene.light({15.0f, 0.0f});
    EXPECT_GT(scene.errors(exactTechnique(), nullptr).wrongShare, 0.3);
}

}  // namespace
}  // namespace relievo::viewer
