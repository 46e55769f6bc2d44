// Pictures of a surface on its relief: where they appear, how they are averaged, and that nothing
// is loaded or read in vain.
#include <gtest/gtest.h>

#include <cmath>

#include "relief_scene.h"

namespace relievo::viewer {
namespace {

using materials::ShadingModel;
using materials::TextureSet;
using Planes = std::vector<textures::Plane>;

constexpr int kSize = 64;

// A flat relief halfway down that fills the frame, seen from straight above.
class FlatScene {
  public:
    explicit FlatScene(TextureSet textures, ShadingModel model = ShadingModel::Microfacet)
        : renderer_(flatMaps(), "test", std::move(textures)) {
        renderer_.setSurface(surfaces::makeQuad({1, 1}, 1.0f));
        view.camera = parallelRays(0.0f, 90.0f, 1.0f);
        view.shading.model = model;
    }

    // The picture in linear light, as red, green, blue and alpha from the top left.
    std::vector<float> draw(int size = kSize) {
        gl::Framebuffer target = makeColorTarget(size, size);
        materials::ReliefMaterial material =
            renderer_.makeMaterial(materials::findTechnique("normal"));
        renderer_.draw(material, view, target);
        std::vector<float> pixels = target.read(0);
        for (float& value : pixels)
            value = value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
        return pixels;
    }

    // The red of the middles of the four quarters: top left, top right, bottom left, bottom right.
    std::array<float, 4> quarters() {
        const std::vector<float> pixels = draw();
        std::array<float, 4> result{};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t x = 16 + 32 * (k % 2);
            const std::size_t y = 16 + 32 * (k / 2);
            result[k] = pixels[4 * (kSize * y + x)];
        }
        return result;
    }

    View view;

  private:
    static textures::MapSet flatMaps() {
        textures::MapSet maps;
        maps.channels = {{"depth", textures::Plane(4, 4, 0.5f)}};
        return maps;
    }

    SceneRenderer renderer_;
};

class Textures : public testing::Test {
  protected:
    // 2×2 texels, the middles of the quarters.
    static textures::Plane quarters(std::array<float, 4> values) {
        textures::Plane plane(2, 2);
        plane.texels.assign(values.begin(), values.end());
        return plane;
    }
    static textures::Plane even(float value) { return textures::Plane(2, 2, value); }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// Seen in the mirrored direction, the smoother the brighter.
TEST_F(Textures, RoughnessAppearsWhereThePictureHasIt) {
    FlatScene scene({.pictures = {{"roughness", {quarters({0.5f, 0.7f, 0.85f, 1.0f})}}}});
    scene.view.shading.metalness = 1.0f;
    const auto seen = scene.quarters();
    EXPECT_GT(seen[0], seen[1] + 0.02f);
    EXPECT_GT(seen[1], seen[2] + 0.02f);
    EXPECT_GT(seen[2], seen[3] + 0.02f);
}

// Away from the mirrored direction a metal shows nothing of the light.
TEST_F(Textures, MetalnessAppearsWhereThePictureHasIt) {
    FlatScene scene({.pictures = {{"metalness", {quarters({0.0f, 1.0f, 0.5f, 0.0f})}}}});
    scene.view.shading.roughness = 0.2f;
    scene.view.toLight = directionTowards(0.0f, 40.0f);
    const auto seen = scene.quarters();
    EXPECT_NEAR(seen[0], seen[3], 0.01f);
    EXPECT_NEAR(seen[2], 0.5f * (seen[0] + seen[1]), 0.02f);
    EXPECT_GT(seen[0], seen[1] + 0.15f);
}

// Occlusion takes of the light from all around, of both models, and nothing of the lamp's.
TEST_F(Textures, OcclusionDarkensTheAmbientLightOnly) {
    for (const ShadingModel model : {ShadingModel::BlinnPhong, ShadingModel::Microfacet}) {
        FlatScene scene({.pictures = {{"occlusion", {quarters({1.0f, 0.5f, 0.25f, 0.0f})}}}},
                        model);
        scene.view.toLight = glm::vec3(0, 0, -1);
        const auto seen = scene.quarters();
        EXPECT_GT(seen[0], 0.1f);
        EXPECT_NEAR(seen[1], 0.5f * seen[0], 0.01f);
        EXPECT_NEAR(seen[2], 0.25f * seen[0], 0.01f);
        EXPECT_NEAR(seen[3], 0.0f, 0.005f);
        scene.view.toLight = directionTowards(0.0f, 30.0f);
        EXPECT_GT(scene.quarters()[3], 0.15f);
    }
}

// Baked occlusion is as dark as it was baked at its own depth scale, and gone without depth.
TEST_F(Textures, BakedOcclusionFollowsTheDepthScale) {
    const auto ambient = [](float occlusion, float occlusionScale, float depthScale) {
        FlatScene scene(
            {.pictures = {{"occlusion", {even(occlusion)}}}, .occlusionScale = occlusionScale});
        scene.view.toLight = glm::vec3(0, 0, -1);
        scene.view.depthScale = depthScale;
        return scene.quarters()[0];
    };
    const float open = ambient(1.0f, 0.1f, 0.1f);
    EXPECT_NEAR(ambient(0.5f, 0.1f, 0.1f), 0.5f * open, 0.01f);
    EXPECT_NEAR(ambient(0.5f, 0.1f, 0.0f), open, 0.002f);
    // A horizon at 45° all around leaves a half; at twice the depth its tangent is 2.
    EXPECT_NEAR(ambient(0.5f, 0.1f, 0.2f), open / (1.0f + 4.0f), 0.01f);
    // Occlusion of a picture says nothing of a scale.
    EXPECT_NEAR(ambient(0.5f, 0.0f, 0.2f), 0.5f * open, 0.01f);
}

TEST_F(Textures, APackedPictureIsTheSameAsThree) {
    const textures::Plane occlusion = quarters({1.0f, 0.8f, 0.3f, 0.6f});
    const textures::Plane roughness = quarters({0.3f, 0.9f, 0.5f, 0.7f});
    const textures::Plane metalness = quarters({0.0f, 1.0f, 0.2f, 0.6f});
    FlatScene three(
        {.pictures = {
             {"occlusion", {occlusion}}, {"roughness", {roughness}}, {"metalness", {metalness}}}});
    FlatScene packed({.pictures = {{"orm", {occlusion, roughness, metalness}}}});
    EXPECT_EQ(three.draw(), packed.draw());
    FlatScene mixedUp({.pictures = {{"orm", {occlusion, metalness, roughness}}}});
    EXPECT_NE(three.draw(), mixedUp.draw());
}

// Far away a chequered picture is its mean; taking texels of the first level would be noise.
TEST_F(Textures, AreAveragedOverTheFootprintOfAPixel) {
    textures::Plane chequers(64, 64);
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i)
            chequers.at(i, j) = static_cast<float>((i + j) % 2);
    const auto red = [](TextureSet set) {
        FlatScene scene(std::move(set));
        scene.view.shading.roughness = 1.0f;
        scene.view.toLight = directionTowards(0.0f, 40.0f);
        return scene.draw(8);
    };
    const std::vector<float> mean = red({.pictures = {{"metalness", {even(0.5f)}}}});
    const std::vector<float> far = red({.pictures = {{"metalness", {chequers}}}});
    for (std::size_t k = 0; k < mean.size(); ++k)
        ASSERT_NEAR(far[k], mean[k], 0.01f);
    // Colours are averaged in linear light: half of white is sRGB 0.735.
    const std::vector<float> grey = red({.pictures = {{"albedo", Planes(3, even(0.735357f))}}});
    const std::vector<float> colours = red({.pictures = {{"albedo", Planes(3, chequers)}}});
    for (std::size_t k = 0; k < grey.size(); ++k)
        ASSERT_NEAR(colours[k], grey[k], 0.01f);
}

TEST_F(Textures, AreUploadedWhenTheShadingReadsThem) {
    materials::SurfaceTextures set({.pictures = {{"albedo", Planes(3, even(0.5f))},
                                                 {"roughness", {even(0.5f)}},
                                                 {"occlusion", {even(0.5f)}}}});
    const auto bind = [&](const materials::Shading& shading) {
        materials::ProgramCache programs;
        gl::Program& program =
            programs.get("relievo/programs/shaded.frag", {materials::findTechnique("normal").file},
                         set.defines(shading));
        const GLuint units = set.bind(program, shading, 5) - 5;
        EXPECT_EQ(program.hasUniform("relievoRoughnessMap"),
                  shading.model == ShadingModel::Microfacet);
        EXPECT_FALSE(program.hasUniform("relievoMetalnessMap"));
        EXPECT_FALSE(program.hasUniform("relievoRoughness"));
        return units;
    };
    EXPECT_EQ(set.uploadedCount(), 0u);
    EXPECT_EQ(bind({}), 2u);
    EXPECT_EQ(set.uploadedCount(), 2u);
    EXPECT_EQ(bind({.model = ShadingModel::Microfacet}), 3u);
    EXPECT_EQ(set.uploadedCount(), 3u);
}

}  // namespace
}  // namespace relievo::viewer
