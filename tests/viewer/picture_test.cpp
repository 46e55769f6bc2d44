// The exact picture, error images, heat maps and contact sheets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "materials/technique_registry.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"
#include "viewer/contact_sheet.h"
#include "viewer/error_image.h"
#include "viewer/heat_map.h"

namespace relievo::viewer {
namespace {

constexpr int kSize = 96;

// Share of the pixels that differ by more than 8 of 255 in some channel.
double differingShare(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t differing = 0;
    for (std::size_t k = 0; k < a.size(); k += 4) {
        float difference = 0.0f;
        for (std::size_t c = 0; c < 3; ++c)
            difference = std::max(difference, std::abs(a[k + c] - b[k + c]));
        differing += difference > 8.0f / 255.0f;
    }
    return static_cast<double>(differing) / (static_cast<double>(a.size()) / 4.0);
}

class Pictures : public testing::TestWithParam<textures::WrapMode> {
  protected:
    // In perspective, over several tiles, so that seams and borders are in the picture.
    static View tiledView() {
        View view;
        OrbitCamera orbit;
        orbit.elevation = 30.0f;
        orbit.distance = 1.2f;
        view.camera = perspectiveCamera(orbit, 1.0f);
        view.toLight = directionTowards(-50.0f, 40.0f);
        view.window = {0, 0, 3, 3};
        return view;
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// A search that is fine enough shows what the reference shows; rows upside down do not.
TEST_P(Pictures, FineSearchLooksLikeTheReference) {
    textures::DepthMap map = textures::generateSampleRelief("noise", 64, 48);
    map.wrap = GetParam();
    SceneRenderer renderer(bakeMaps(map), "test", {});
    renderer.setSurface(surfaces::makeQuad({3, 3}, 0.75f));
    const View view = tiledView();
    gl::Framebuffer target = makeColorTarget(kSize, kSize);
    ReferenceFrame exact = renderer.trace(view, kSize, kSize);
    renderer.drawReference(exact, view, target);
    const std::vector<float> truth = target.read(0);

    materials::ReliefMaterial fine = renderer.makeMaterial(materials::findTechnique("relief"));
    fine.pixelRays = 1;  // as the exact picture has
    fine.setParameter("linear-steps", 1024);
    fine.setParameter("binary-steps", 12);
    renderer.draw(fine, view, target);
    EXPECT_LT(differingShare(truth, target.read(0)), 0.01);

    materials::ReliefMaterial cone = renderer.makeMaterial(materials::findTechnique("cone"));
    cone.pixelRays = 1;
    renderer.draw(cone, view, target);
    EXPECT_LT(differingShare(truth, target.read(0)), 0.02);

    std::ranges::reverse(exact.pixels);
    renderer.drawReference(exact, view, target);
    EXPECT_GT(differingShare(truth, target.read(0)), 0.1);
}

INSTANTIATE_TEST_SUITE_P(WrapModes, Pictures,
                         testing::Values(textures::WrapMode::Repeat, textures::WrapMode::Mirror,
                                         textures::WrapMode::Clamp),
                         [](const auto& test) {
                             return std::string(textures::wrapModeName(test.param));
                         });

// One step of cone tracing leads nowhere near the surface: such pixels are holes, or magenta.
TEST_F(Pictures, ExhaustedSearchesAreNeverShadedAsHits) {
    RayScene scene(bakeMaps(textures::generateSampleRelief("noise", 64, 64)), 30.0f, 10.0f);
    materials::ReliefMaterial material =
        scene.renderer.makeMaterial(materials::findTechnique("cone"));
    material.setParameter("cone-steps", 1);
    const WorkCounts work = countWork(scene.renderer.measure(material, scene.view, kSize, kSize));
    EXPECT_GT(work.exhausted, work.pixels / 2);

    gl::Framebuffer target = makeColorTarget(kSize, kSize);
    const auto count = [&](glm::vec3 color) {
        const std::vector<float> pixels = target.read(0);
        std::size_t matching = 0;
        for (std::size_t k = 0; k < pixels.size(); k += 4)
            matching += std::abs(pixels[k] - color.r) + std::abs(pixels[k + 1] - color.g) +
                            std::abs(pixels[k + 2] - color.b) <
                        0.02f;
        return matching;
    };
    scene.renderer.draw(material, scene.view, target);
    EXPECT_EQ(count({0.09f, 0.09f, 0.1f}), work.exhausted);
    scene.view.markExhausted = true;
    scene.renderer.draw(material, scene.view, target);
    EXPECT_EQ(count({1, 0, 1}), work.exhausted);
}

MeasuredFrame pixelFrame(int outcome, float t) {
    MeasuredFrame frame{1, 1, {}};
    MeasuredPixel pixel;
    pixel.covered = true;
    pixel.outcome = outcome;
    pixel.t = t;
    pixel.direction = {0, 0, 1};
    frame.pixels.push_back(pixel);
    return frame;
}

TEST(ErrorImageTest, TellsDistancesAndVerdicts) {
    const textures::DepthMap map{textures::Plane(10, 10, 0.5f), textures::WrapMode::Repeat};
    ReferenceFrame exact{1, 1, {ReferencePixel{true, true, 0.5, {0, 0, 0.5}, {0, 0, 1}}}};
    const auto verdict = [&](const MeasuredFrame& frame) {
        return static_cast<PixelVerdict>(
            static_cast<int>(makeErrorImage(frame, exact, map, 0.1).verdict.at(0, 0)));
    };
    // 0.1 deeper at a depth scale of 0.1 is 0.01 tile widths: 0.1 texels of 10.
    const ErrorImage image = makeErrorImage(pixelFrame(RELIEVO_OUTCOME_HIT, 0.6f), exact, map, 0.1);
    EXPECT_NEAR(image.distance.at(0, 0), 0.1f, 1e-6f);
    EXPECT_EQ(verdict(pixelFrame(RELIEVO_OUTCOME_HIT, 0.6f)), PixelVerdict::Compared);
    EXPECT_EQ(verdict(pixelFrame(RELIEVO_OUTCOME_MISS, 0.6f)), PixelVerdict::Mismatch);
    EXPECT_EQ(verdict(pixelFrame(RELIEVO_OUTCOME_EXHAUSTED, 0.6f)), PixelVerdict::Exhausted);
    exact.pixels[0].hit = false;
    EXPECT_EQ(verdict(pixelFrame(RELIEVO_OUTCOME_HIT, 0.6f)), PixelVerdict::Mismatch);
    EXPECT_EQ(verdict(pixelFrame(RELIEVO_OUTCOME_MISS, 0.6f)), PixelVerdict::Compared);
    MeasuredFrame uncovered = pixelFrame(RELIEVO_OUTCOME_HIT, 0.6f);
    uncovered.pixels[0].covered = false;
    EXPECT_EQ(verdict(uncovered), PixelVerdict::Uncovered);
}

TEST(HeatMapTest, BrightnessGrowsWithTheError) {
    float last = -1.0f;
    for (float texels = kHeatMinimum; texels <= kHeatMaximum; texels *= 2) {
        const glm::vec3 color = heatColor(texels);
        const float luminance = 0.2126f * color.r + 0.7152f * color.g + 0.0722f * color.b;
        EXPECT_GT(luminance, last) << texels;
        EXPECT_EQ(heatColor(-texels), color);
        last = luminance;
    }
    EXPECT_EQ(heatColor(0.0f), heatColor(kHeatMinimum));
    EXPECT_EQ(heatColor(1e9f), heatColor(kHeatMaximum));
}

TEST(ContactSheetTest, HoldsEveryPictureWhole) {
    Picture red(40, 30);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            red.pixel(x, y)[0] = 1.0f;
            red.pixel(x, y)[3] = 1.0f;
        }
    const SheetCell cell{red, "a long title that does not fit — ρ°", "sub"};
    const Picture sheet = makeContactSheet({{cell, cell}, {cell}}, Picture());
    std::size_t redPixels = 0;
    for (std::size_t k = 0; k < sheet.rgba.size(); k += 4)
        redPixels += sheet.rgba[k] == 1.0f && sheet.rgba[k + 1] == 0.0f;
    EXPECT_EQ(redPixels, 3u * 40 * 30);
}

}  // namespace
}  // namespace relievo::viewer
