// Shading in step with the depth scale, and the way of a picture from its file to the screen.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "materials/technique_registry.h"
#include "reference/bilinear_tracer.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/height_image.h"
#include "textures/picture_file.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

class Shading : public testing::Test {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

TEST_F(Shading, NormalsFollowTheDepthScale) {
    const textures::MapSet maps = bakeMaps(textures::generateSampleRelief("wave", 256, 256));
    for (const float scale : {0.02f, 0.1f, 0.3f, 1.0f}) {
        RayScene scene(maps, 30.0f, 40.0f, scale);
        materials::ReliefMaterial material =
            scene.renderer.makeMaterial(materials::findTechnique("relief"));
        material.setParameter("linear-steps", 512);
        material.setParameter("binary-steps", 12);
        const reference::ErrorStatistics errors = scene.errors(material, 96);
        EXPECT_LT(errors.wrongShare, 0.001) << scale;
        EXPECT_LT(errors.meanNormalAngle, 1.0) << scale;
        // The normals of another scale must not pass for those of this one.
        RayScene other(maps, 30.0f, 40.0f, scale);
        const MeasuredFrame frame = other.renderer.measure(material, other.view, 96, 96);
        const ReferenceFrame exact =
            traceReference(frame, other.renderer.depthMap(), other.view.window, 1.5 * scale);
        const auto wrong = reference::summarizeErrors(
            compareFrames(frame, exact, other.renderer.depthMap(), scale), 1.0);
        EXPECT_GT(wrong.meanNormalAngle, 2 * errors.meanNormalAngle) << scale;
    }
}

TEST_F(Shading, WithoutDepthTheReliefIsFlatAndItsNormalsStraight) {
    const textures::DepthMap map = textures::generateSampleRelief("cobbles", 64, 64);
    for (const materials::Technique& technique : materials::techniques()) {
        RayScene scene(bakeMapsFor(technique, map), 30.0f, 20.0f, 0.0f);
        materials::ReliefMaterial material = scene.renderer.makeMaterial(technique);
        for (const MeasuredPixel& pixel :
             scene.renderer.measure(material, scene.view, 32, 32).pixels) {
            ASSERT_TRUE(pixel.covered);
            EXPECT_EQ(pixel.outcome, RELIEVO_OUTCOME_HIT) << technique.name;
            EXPECT_EQ(pixel.hit.x, pixel.origin.x) << technique.name;
            EXPECT_EQ(pixel.hit.y, pixel.origin.y) << technique.name;
            EXPECT_EQ(pixel.normal, glm::vec3(0, 0, 1)) << technique.name;
        }
    }
}

// Rays this low end in tiles around the first one, every other of which is mirrored: its slopes are
// reversed along the mirrored axis, or the light would come from the wrong side there.
TEST_F(Shading, MirroredTilesHaveMirroredNormals) {
    textures::DepthMap map = textures::generateSampleRelief("cobbles", 128, 128);
    const materials::Technique& technique = materials::findTechnique("exact");
    for (const float azimuth : {30.0f, 120.0f, 210.0f, 300.0f}) {
        double angles[2];
        for (const textures::WrapMode wrap :
             {textures::WrapMode::Repeat, textures::WrapMode::Mirror}) {
            map.wrap = wrap;
            RayScene scene(bakeMapsFor(technique, map), azimuth, 4.0f);
            angles[wrap == textures::WrapMode::Mirror] =
                scene.errors(technique, 96).meanNormalAngle;
        }
        // As good as without mirrors. Reversed slopes are wrong by tens of degrees.
        EXPECT_LT(angles[1], angles[0] + 2.0) << azimuth;
    }
}

// A lone bump shades brighter on the side that faces the light: derivatives of a depth map, a world
// normal and a light direction must agree on all three axes.
TEST_F(Shading, TheSideThatFacesTheLightIsBrighter) {
    textures::DepthMap map{textures::Plane(64, 64, 1.0f), textures::WrapMode::Repeat};
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i)
            map.depth.at(i, j) = static_cast<float>(
                1.0 - std::exp(-((i - 31.5) * (i - 31.5) + (j - 31.5) * (j - 31.5)) / 200.0));
    RayScene scene(bakeMaps(map), 0.0f, 90.0f, 0.2f);
    gl::Framebuffer target = makeColorTarget(64, 64);
    const auto brightness = [&](int x, int y) {
        return target.read(0)[static_cast<std::size_t>(4 * (y * 64 + x))];
    };
    struct Case {
        float azimuth;
        int brightX, brightY, darkX, darkY;
    };
    // Azimuth 0 stands at −y, the lower edge of the picture; 90 at +x, its right edge.
    for (const Case& c : {Case{0, 32, 44, 32, 20}, Case{90, 44, 32, 20, 32},
                          Case{180, 32, 20, 32, 44}, Case{270, 20, 32, 44, 32}}) {
        scene.view.toLight = directionTowards(c.azimuth, 30.0f);
        materials::ReliefMaterial material =
            scene.renderer.makeMaterial(materials::findTechnique("normal"));
        scene.renderer.draw(material, scene.view, target);
        EXPECT_GT(brightness(c.brightX, c.brightY), brightness(c.darkX, c.darkY) + 0.1f)
            << c.azimuth;
    }
}

// The origin of (u,v) is the top left of the picture, from the file to the screen.
TEST_F(Shading, TopLeftOfTheFileIsTopLeftOnTheScreen) {
    const auto folder = std::filesystem::temp_directory_path() / "relievo_orientation_test";
    std::filesystem::create_directories(folder);
    textures::Plane height(8, 8, 0.25f);
    height.at(0, 0) = 1.0f;  // the top left texel stands out
    height.at(7, 0) = 0.5f;
    height.at(0, 7) = 0.75f;
    const std::array planes = {height};
    textures::writePicture(folder / "height.png", planes, textures::StorageFormat::U16);
    const textures::DepthMap map = textures::readHeightImage(folder / "height.png", {}).depth;
    std::filesystem::remove_all(folder);

    RayScene scene(bakeMaps(map), 0.0f, 90.0f);
    materials::ReliefMaterial material =
        scene.renderer.makeMaterial(materials::findTechnique("cone"));
    const MeasuredFrame frame = scene.renderer.measure(material, scene.view, 8, 8);
    const auto depthAt = [&](int x, int y) {
        return frame.pixels[static_cast<std::size_t>(8 * y + x)].hit.z;
    };
    EXPECT_NEAR(depthAt(0, 0), 0.0, 1e-3);
    EXPECT_NEAR(depthAt(7, 0), 0.5, 1e-3);
    EXPECT_NEAR(depthAt(0, 7), 0.25, 1e-3);
    EXPECT_NEAR(depthAt(7, 7), 0.75, 1e-3);
}

TEST_F(Shading, AlbedoAppearsWhereThePictureHasIt) {
    std::vector<textures::Plane> albedo(3, textures::Plane(2, 2));
    const std::array<glm::vec3, 4> colors = {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0),
                                             glm::vec3(0, 0, 1), glm::vec3(1, 1, 0)};
    for (int k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c)
            albedo[static_cast<std::size_t>(c)].at(k % 2, k / 2) =
                colors[static_cast<std::size_t>(k)][c];
    textures::DepthMap map{textures::Plane(4, 4, 0.5f), textures::WrapMode::Repeat};
    SceneRenderer renderer(bakeMaps(map), "test", {.pictures = {{"albedo", albedo}}});
    renderer.setSurface(surfaces::makeQuad({1, 1}, 1.0f));
    View view;
    view.camera = parallelRays(0.0f, 90.0f, 1.0f);
    gl::Framebuffer target = makeColorTarget(64, 64);
    materials::ReliefMaterial material = renderer.makeMaterial(materials::findTechnique("relief"));
    renderer.draw(material, view, target);
    const std::vector<float> pixels = target.read(0);
    for (int k = 0; k < 4; ++k) {
        // The middle of each quarter is the middle of a texel.
        const int x = 16 + 32 * (k % 2);
        const int y = 16 + 32 * (k / 2);
        const float* pixel = &pixels[static_cast<std::size_t>(4 * (64 * y + x))];
        const glm::vec3 color = colors[static_cast<std::size_t>(k)];
        for (int c = 0; c < 3; ++c) {
            if (color[c] > 0.5f)
                EXPECT_GT(pixel[c], 0.5f) << k;
            else
                EXPECT_LT(pixel[c], 0.45f) << k;
        }
    }
}

}  // namespace
}  // namespace relievo::viewer
