// Every method of self-shadowing against the exact visibility, on every sample relief, under lights
// that are points and discs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <map>
#include <set>
#include <string>

#include "bench/technique_maps.h"
#include "materials/shadow_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "surfaces/surface_mesh.h"
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

// A relief from 60°, under a light.
class LitScene {
  public:
    LitScene(const textures::DepthMap& map, const preprocess::ReliefPlan& plan,
             float depthScale = 0.1f)
        : LitScene(preprocess::bakeRelief(map, plan)) {
        scene_.look(30.0f, 60.0f, depthScale);
    }
    explicit LitScene(const textures::MapSet& maps, glm::vec2 tiles = {1.0f, 1.0f})
        : scene_(maps, 30.0f, 60.0f) {
        scene_.renderer.setSurface(surfaces::makeQuad(tiles, 1.0f));
    }

    void light(const Light& light, float azimuth = -50.0f) {
        scene_.view.toLight = directionTowards(azimuth, light.elevation);
        scene_.view.lightRadius = glm::radians(light.size / 2.0f);
        scene_.view.lightRays = kLightRays;
        exact_ = scene_.renderer.trace(scene_.view, kFrameSize, kFrameSize);
    }

    MeasuredFrame measure(const materials::Technique& technique,
                          const materials::ShadowMethod* method,
                          const std::map<std::string, double>& parameters = {}) {
        materials::ReliefMaterial material = scene_.renderer.makeMaterial(technique);
        material.setShadow(method);
        for (const auto& [name, value] : parameters)
            material.setParameter(name, value);
        return scene_.renderer.measure(material, scene_.view, kFrameSize, kFrameSize);
    }

    LightErrors errors(const materials::Technique& technique, const materials::ShadowMethod* method,
                       const std::map<std::string, double>& parameters = {}) {
        return summarizeLight(measure(technique, method, parameters), exact_);
    }

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

// Light rays go down from where they enter the relief, so that all maps keep their promises. Next
// to each technique that finds first hits the shadows are right; the others are wrong where their
// hits are, and where their light rays step over something.
TEST_F(Shadows, LightRaysAreSearchedByAnyTechnique) {
    const std::set<std::string_view> sure = {"cone", "relaxed", "relaxed-secant", "pyramid",
                                             "exact"};
    const materials::ShadowMethod& search = materials::findShadowMethod("search");
    for (const materials::Technique* technique : everyTechnique()) {
        if (!technique->isSearch)
            continue;
        double worst = 0.0;
        for (const char* sample : {"noise", "blocks", "hemispheres"}) {
            LitScene scene(sampleMap(sample), bench::planFor(*technique));
            scene.light({30.0f, 0.0f});
            worst = std::max(worst, 100 * scene.errors(*technique, &search).wrongShare);
        }
        fmt::print("{:20} {:7.3f} % of the pixels wrongly lit or dark\n", technique->name, worst);
        EXPECT_LE(worst, sure.contains(technique->name) ? 0.5 : 25.0) << technique->name;
    }
}

// One blocker height for the whole light hides too much behind what is narrower than the light.
TEST_F(Shadows, SlicesTellWhatIsNarrowerThanTheLight) {
    const materials::ShadowMethod& soft = materials::findShadowMethod("soft");
    LitScene scene(sampleMap("pillars"), bench::planFor(exactTechnique(), &soft));
    scene.light({15.0f, kDisc});
    const auto errorsWith = [&](int slices) {
        const LightErrors errors =
            scene.errors(exactTechnique(), &soft, {{"shadow-slices", slices}});
        fmt::print("{:2} slices: {:6.3f} % wrong, {:.1f} fetches\n", slices,
                   100 * errors.wrongShare, errors.meanFetches);
        return errors;
    };
    const LightErrors one = errorsWith(1);
    const LightErrors two = errorsWith(2);
    const LightErrors four = errorsWith(4);
    EXPECT_LT(two.wrongShare, 0.7 * one.wrongShare);
    EXPECT_LT(four.wrongShare, 0.1 * one.wrongShare);
    EXPECT_LT(four.meanFetches, 4 * one.meanFetches);
}

// The map's horizons as if it were mirrored in u.
textures::MapSet turned(textures::MapSet maps, int azimuths) {
    for (textures::Channel& channel : maps.channels)
        if (channel.name.starts_with("horizon")) {
            const int k = std::stoi(channel.name.substr(std::string("horizon").size()));
            channel.name = fmt::format("horizon{}", (azimuths + azimuths / 2 - k) % azimuths);
        }
    return maps;
}

// In every second tile of a mirrored map the light comes from the other side.
TEST_F(Shadows, MirroredTilesAreLitFromTheRightSide) {
    const textures::DepthMap map = sampleMap("cobbles", textures::WrapMode::Mirror);
    for (const materials::ShadowMethod* method : everyMethod()) {
        SCOPED_TRACE(std::string(method->name));
        const preprocess::ReliefPlan plan = bench::planFor(exactTechnique(), method);
        const textures::MapSet maps = preprocess::bakeRelief(map, plan);
        LitScene scene(maps, {2.0f, 2.0f});
        scene.light({30.0f, 0.0f});
        const double wrong = scene.errors(exactTechnique(), method).wrongShare;
        fmt::print("{:8} on mirrored tiles: {:.2f} % wrong\n", method->name, 100 * wrong);
        EXPECT_LE(100 * wrong, 1.2 * method->errors.at15.pointPercent);
        if (method->name != "horizon")
            continue;
        LitScene wrongScene(turned(maps, plan.azimuths), {2.0f, 2.0f});
        wrongScene.light({30.0f, 0.0f});
        EXPECT_GT(wrongScene.errors(exactTechnique(), method).wrongShare, 2 * wrong);
    }
}

// The light that is not blocked anywhere, and the one from below.
TEST_F(Shadows, OfLightFromStraightAboveAndFromBelow) {
    for (const materials::ShadowMethod* method : everyMethod())
        for (const float depthScale : {0.0f, 0.1f}) {
            SCOPED_TRACE(testing::Message() << method->name << ", " << depthScale);
            LitScene scene(sampleMap("noise"), bench::planFor(exactTechnique(), method),
                           depthScale);
            for (const float elevation : {90.0f, -20.0f}) {
                scene.light({elevation, 4.0f});
                for (const MeasuredPixel& pixel : scene.measure(exactTechnique(), method).pixels)
                    ASSERT_EQ(pixel.lightShare, elevation > 0.0f ? 1.0f : 0.0f) << elevation;
            }
        }
}

}  // namespace
}  // namespace relievo::viewer
