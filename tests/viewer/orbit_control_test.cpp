#include "viewer/orbit_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <random>

namespace relievo::viewer {
namespace {

constexpr float kHeight = 600.0f;

// Where a point of the world is on a square frame, in pixels from its middle, y down.
glm::vec2 onScreen(const OrbitCamera& camera, const glm::vec3& point) {
    const glm::vec4 clip = perspectiveCamera(camera, 1.0f).viewProjection * glm::vec4(point, 1.0f);
    return 0.5f * kHeight * glm::vec2(clip.x, -clip.y) / clip.w;
}

using Pan = OrbitCamera (*)(const OrbitCamera&, float, float, float);

// The largest distance by which the target's old place misses the pointer after `pan`.
float largestPanError(Pan pan) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> angle(-80, 80);
    std::uniform_real_distribution<float> pixels(-100, 100);
    float worst = 0.0f;
    for (int k = 0; k < 100; ++k) {
        OrbitCamera camera;
        camera.azimuth = 2 * angle(random);
        camera.elevation = angle(random);
        const glm::vec2 moved(pixels(random), pixels(random));
        const OrbitCamera after = pan(camera, moved.x, moved.y, kHeight);
        worst = std::max(worst, glm::length(onScreen(after, camera.target) - moved));
    }
    return worst;
}

TEST(OrbitControl, PanningKeepsThePointUnderThePointer) {
    EXPECT_LT(largestPanError(panned), 0.05f);
    // The same check finds a pan that goes the wrong way up.
    EXPECT_GT(largestPanError([](const OrbitCamera& camera, float dx, float dy, float height) {
                  return panned(camera, dx, -dy, height);
              }),
              50.0f);
}

TEST(OrbitControl, TheFrontFollowsThePointer) {
    const OrbitCamera camera;
    const glm::vec3 front = 0.3f * directionTowards(camera.azimuth, camera.elevation);
    EXPECT_GT(onScreen(orbited(camera, 30, 0, kHeight), front).x, 1.0f);
    EXPECT_GT(onScreen(orbited(camera, 0, 30, kHeight), front).y, 1.0f);
}

TEST(OrbitControl, HalfATurnPerFrameAndNoFlipAtThePoles) {
    OrbitCamera camera;
    camera.azimuth = 170;
    camera.elevation = 80;
    EXPECT_NEAR(orbited(camera, -kHeight / 6, 0, kHeight).azimuth, -160.0f, 1e-3f);
    EXPECT_LT(orbited(camera, 0, 1e6f, kHeight).elevation, 90.0f);
    EXPECT_GT(orbited(camera, 0, -1e6f, kHeight).elevation, -90.0f);
}

TEST(OrbitControl, ZoomGoesThereAndBackWithinItsLimits) {
    const OrbitCamera camera;
    const OrbitCamera near = zoomed(camera, 3);
    EXPECT_LT(near.distance, camera.distance);
    EXPECT_NEAR(zoomed(near, -3).distance, camera.distance, 1e-5f);
    EXPECT_GT(zoomed(camera, 1e4f).distance, 0.0f);
    EXPECT_LE(zoomed(camera, -1e4f).distance, 50.0f);
}

TEST(OrbitControl, ALargeSceneIsSeenFromAfar) {
    OrbitCamera far;
    far.distance = 35.0f;
    const ZoomLimits limits = zoomLimitsAround(far);
    EXPECT_EQ(zoomed(far, -1000.0f, limits).distance, limits.farthest);
    EXPECT_GT(limits.farthest, 5 * far.distance);
    EXPECT_EQ(zoomLimitsAround(OrbitCamera{}).farthest, ZoomLimits{}.farthest);
    // Near the target, what lies behind it is not cut off.
    far.reach = 140.0f;
    const OrbitCamera near = zoomed(far, 1000.0f, limits);
    EXPECT_EQ(near.distance, limits.nearest);
    const glm::vec3 behind = -139.0f * directionTowards(near.azimuth, near.elevation);
    const auto depthOf = [&](const OrbitCamera& camera) {
        const glm::vec4 clip =
            perspectiveCamera(camera, 1.0f).viewProjection * glm::vec4(behind, 1.0f);
        return clip.z / clip.w;
    };
    EXPECT_LT(depthOf(near), 1.0f);
    OrbitCamera usual = near;
    usual.reach = OrbitCamera{}.reach;
    EXPECT_GT(depthOf(usual), 1.0f);
}

}  // namespace
}  // namespace relievo::viewer
