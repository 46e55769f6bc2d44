// What `auto` promises: no point of the picture is out of place by more than a fraction of a pixel,
// whatever it leaves out, and what it need not look up it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <random>

#include "bench/technique_maps.h"
#include "materials/detail_choice.h"
#include "materials/shadow_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

constexpr int kMapSize = 64;
constexpr int kFrameSize = 48;
constexpr double kDefaultError = 0.25;  // of the parameter pixel-error

const materials::Technique& autoTechnique() {
    return materials::findTechnique("auto");
}

// Where a world point is in a frame of kFrameSize² pixels.
glm::dvec2 onScreen(const glm::mat4& viewProjection, const glm::dvec3& point) {
    const glm::dvec4 clip = glm::dmat4(viewProjection) * glm::dvec4(point, 1.0);
    return 0.5 * kFrameSize * glm::dvec2(clip) / clip.w;
}

// The world point of a relief on makeQuad that lies on the ray of `pixel` at t.
glm::dvec3 worldPoint(const MeasuredPixel& pixel, double t, double depthScale) {
    const glm::dvec3 p = glm::dvec3(pixel.origin) + t * glm::dvec3(pixel.direction);
    return {p.x - 0.5, 0.5 - p.y, -depthScale * p.z};
}

class Auto : public testing::Test {
  protected:
    static RayScene sceneOf(const textures::DepthMap& map) {
        return RayScene(preprocess::bakeRelief(map, bench::planFor(autoTechnique())), 0.0f, 90.0f);
    }

    // The furthest that a point is out of place in pixels, as seen, over the frame: a hit and the
    // exact one on the same ray are the same point of the screen, so what is compared is where the
    // points of the surface are that lie above them.
    static double worstShift(RayScene& scene, const materials::ReliefMaterial& material) {
        materials::ReliefMaterial used = material;
        const MeasuredFrame frame =
            scene.renderer.measure(used, scene.view, kFrameSize, kFrameSize);
        const ReferenceFrame exact = traceReference(frame, scene.renderer.depthMap(),
                                                    scene.view.window, scene.view.depthScale);
        double worst = 0.0;
        for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
            const MeasuredPixel& pixel = frame.pixels[k];
            if (!pixel.covered || !exact.pixels[k].hit)
                continue;
            EXPECT_EQ(pixel.outcome, RELIEVO_OUTCOME_HIT);
            glm::dvec3 found = worldPoint(pixel, pixel.t, scene.view.depthScale);
            glm::dvec3 right = worldPoint(pixel, exact.pixels[k].t, scene.view.depthScale);
            found.z = right.z = 0.0;
            worst =
                std::max(worst, glm::distance(onScreen(scene.view.camera.viewProjection, found),
                                              onScreen(scene.view.camera.viewProjection, right)));
        }
        return worst;
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// By how much the size of a pixel on the quad may differ from that of its neighbour, of which the
// shader has only one for four pixels. A ray of elevation e is h/sin e long, so that it is longer
// by the share δ/tan e for an angle lower by δ.
double sizeDifference(float elevation, float distance) {
    const double e = glm::radians(static_cast<double>(elevation));
    const double farthest = distance * std::cos(e) + std::sqrt(0.5);
    const double tangent = distance * std::sin(e) / farthest;
    return glm::radians(40.0) / kFrameSize / tangent;
}

TEST_F(Auto, NoPointIsOutOfPlaceByMoreThanTheTarget) {
    double worstOfAll = 0.0;
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        RayScene scene = sceneOf(textures::generateSampleRelief(sample.name, kMapSize, kMapSize));
        for (const float distance : {0.9f, 2.0f, 4.0f, 6.0f, 9.0f, 15.0f})
            for (const float elevation : {80.0f, 40.0f, 15.0f}) {
                scene.view.camera = perspectiveCamera(
                    {.azimuth = 20.0f, .elevation = elevation, .distance = distance}, 1.0f);
                const double worst =
                    worstShift(scene, scene.renderer.makeMaterial(autoTechnique()));
                EXPECT_LE(worst, kDefaultError * (1.0 + sizeDifference(elevation, distance)))
                    << sample.name << " from " << elevation << "° at " << distance;
                worstOfAll = std::max(worstOfAll, worst);
            }
    }
    // The target is used, or the comparison would prove nothing.
    EXPECT_GT(worstOfAll, 0.5 * kDefaultError);
}

// A search that aims at twice the error is caught by the same measure.
TEST_F(Auto, ALargerTargetIsSeen) {
    RayScene scene = sceneOf(textures::generateSampleRelief("pillars", kMapSize, kMapSize));
    scene.view.camera =
        perspectiveCamera({.azimuth = 20.0f, .elevation = 15.0f, .distance = 4.0f}, 1.0f);
    materials::ReliefMaterial material = scene.renderer.makeMaterial(autoTechnique());
    material.setParameter("pixel-error", 2.0 * kDefaultError);
    EXPECT_GT(worstShift(scene, material), 1.3 * kDefaultError);
}

// From so far away that the relief is flat the program has no search: the same picture as the
// search that finds out pixel by pixel, for no lookups.
TEST_F(Auto, FarAwayIsNotSearched) {
    RayScene scene = sceneOf(textures::generateSampleRelief("spikes", kMapSize, kMapSize));
    const auto measureFrom = [&](float distance, double pixelError) {
        scene.view.camera =
            perspectiveCamera({.azimuth = 20.0f, .elevation = 30.0f, .distance = distance}, 1.0f);
        materials::ReliefMaterial material = scene.renderer.makeMaterial(autoTechnique());
        material.setParameter("pixel-error", pixelError);
        return scene.renderer.measure(material, scene.view, kFrameSize, kFrameSize);
    };
    EXPECT_EQ(countWork(measureFrom(15.0f, kDefaultError)).meanFetches, 0.0);
    EXPECT_GT(countWork(measureFrom(1.5f, kDefaultError)).meanFetches, 2.0);
    EXPECT_GT(countWork(measureFrom(15.0f, 0.001)).meanFetches, 2.0);
}

// Shadows are longer than the relief is deep, so that their light rays begin at true hits.
TEST_F(Auto, LightRaysBeginOnTheRelief) {
    RayScene scene = sceneOf(textures::generateSampleRelief("spikes", kMapSize, kMapSize));
    scene.view.camera =
        perspectiveCamera({.azimuth = 20.0f, .elevation = 30.0f, .distance = 15.0f}, 1.0f);
    materials::ReliefMaterial material = scene.renderer.makeMaterial(autoTechnique());
    material.setShadow(&materials::findShadowMethod("search"));
    EXPECT_LT(worstShift(scene, material), 1e-3);
    material.setShadow(nullptr);
    EXPECT_GT(worstShift(scene, material), 1e-2);
}

// What is drawn does not depend on which of the two programs draws it.
TEST_F(Auto, BothProgramsShowTheSameWhereTheyMeet) {
    RayScene scene = sceneOf(textures::generateSampleRelief("spikes", kMapSize, kMapSize));
    scene.view.camera =
        perspectiveCamera({.azimuth = 20.0f, .elevation = 30.0f, .distance = 9.0f}, 1.0f);
    materials::ReliefMaterial material = scene.renderer.makeMaterial(autoTechnique());
    material.depthScale = scene.view.depthScale;
    const surfaces::SurfaceExtent extent = surfaces::extentOf(surfaces::makeQuad({1, 1}, 1.0f));
    const auto isSearched = [&](double pixelError) {
        material.setParameter("pixel-error", pixelError);
        return &materials::materialForDraw(
                    material, extent, {scene.view.camera.viewProjection, glm::vec2(kFrameSize)})
                    .technique() == &autoTechnique();
    };
    // The least target without a search, and one that is a little less.
    double searched = 0.01;
    double plain = 10.0;
    ASSERT_TRUE(isSearched(searched));
    ASSERT_FALSE(isSearched(plain));
    while (plain - searched > 1e-6) {
        const double middle = 0.5 * (plain + searched);
        (isSearched(middle) ? searched : plain) = middle;
    }
    MeasuredFrame frames[2];
    for (int k = 0; k < 2; ++k) {
        material.setParameter("pixel-error", k == 0 ? searched : plain);
        frames[k] = scene.renderer.measure(material, scene.view, kFrameSize, kFrameSize);
    }
    for (std::size_t k = 0; k < frames[0].pixels.size(); ++k) {
        EXPECT_EQ(frames[0].pixels[k].covered, frames[1].pixels[k].covered);
        EXPECT_EQ(frames[0].pixels[k].t, frames[1].pixels[k].t);
    }
}

// A flat relief is not searched from anywhere; on the top of a plateau one cell is.
TEST_F(Auto, FlatReliefsLeaveAtOnce) {
    for (const float depth : {0.0f, 0.4f, 1.0f}) {
        const textures::DepthMap flat{textures::Plane(16, 16, depth), textures::WrapMode::Repeat};
        RayScene scene = sceneOf(flat);
        for (const float elevation : {90.0f, 30.0f, 1.0f}) {
            scene.look(30.0f, elevation);
            materials::ReliefMaterial material = scene.renderer.makeMaterial(autoTechnique());
            const MeasuredFrame frame = scene.renderer.measure(material, scene.view, 16, 16);
            EXPECT_EQ(countWork(frame).meanFetches, 0.0) << depth;
            for (const MeasuredPixel& pixel : frame.pixels)
                EXPECT_NEAR(pixel.hit.z, depth, 1e-6);
        }
    }
    textures::DepthMap plateau{textures::Plane(16, 16, 0.0f), textures::WrapMode::Repeat};
    plateau.depth.at(3, 3) = 1.0f;
    RayScene scene = sceneOf(plateau);
    scene.look(30.0f, 10.0f);
    materials::ReliefMaterial material = scene.renderer.makeMaterial(autoTechnique());
    for (const MeasuredPixel& pixel : scene.renderer.measure(material, scene.view, 64, 64).pixels)
        if (pixel.hit.z == 0.0f) {
            EXPECT_LE(pixel.fetches, 2.0f);
        }
}

// The bound that lets a whole draw do without a search, against what really moves.
TEST(GreatestShift, BoundsEveryPointOfTheBox) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    double closest = 0.0;
    for (int k = 0; k < 2000; ++k) {
        const Camera camera = perspectiveCamera({.azimuth = 360 * share(random),
                                                 .elevation = 180 * share(random) - 90,
                                                 .distance = 1.5f + 5 * share(random)},
                                                1.0f);
        const surfaces::SurfaceExtent extent{glm::vec3(-0.5f), glm::vec3(0.5f), 1.0f};
        const double length = 1e-4;
        const double bound = materials::greatestShift(
            extent, {camera.viewProjection, glm::vec2(kFrameSize)}, length);
        const glm::dvec3 point(share(random) - 0.5, share(random) - 0.5, share(random) - 0.5);
        const glm::dvec3 way = glm::normalize(
            glm::dvec3(share(random) - 0.5, share(random) - 0.5, share(random) - 0.5));
        const glm::dvec2 before = onScreen(camera.viewProjection, point);
        if (std::max(std::abs(before.x), std::abs(before.y)) > 0.5 * kFrameSize)
            continue;
        const double moved =
            glm::distance(before, onScreen(camera.viewProjection, point + length * way));
        EXPECT_LE(moved, bound);
        closest = std::max(closest, moved / bound);
    }
    EXPECT_GT(closest, 0.3);
}

TEST(GreatestShift, IsInfiniteWhereTheSurfaceReachesTheEye) {
    const Camera camera = perspectiveCamera({.distance = 1.0f}, 1.0f);
    const surfaces::SurfaceExtent large{glm::vec3(-5.0f), glm::vec3(5.0f), 1.0f};
    EXPECT_TRUE(
        std::isinf(materials::greatestShift(large, {camera.viewProjection, glm::vec2(100)}, 0.1)));
}

}  // namespace
}  // namespace relievo::viewer
