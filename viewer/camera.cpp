#include "viewer/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

namespace relievo::viewer {
namespace {

struct ClipPlanes {
    float near;
    float far;
};

ClipPlanes clipPlanes(const OrbitCamera& orbit) {
    return {std::max(0.01f, orbit.distance * 0.02f),
            orbit.distance + std::max(20.0f, 4.0f * orbit.distance)};
}

// The planes in the order in which a projection of glm takes them to the ends of its interval.
ClipPlanes inOrder(ClipPlanes planes, const DepthConvention& depth) {
    if (depth.reversed)
        std::swap(planes.near, planes.far);
    return planes;
}

glm::vec3 eyeOf(const OrbitCamera& orbit) {
    return orbit.target + orbit.distance * directionTowards(orbit.azimuth, orbit.elevation);
}

glm::mat4 viewOf(const OrbitCamera& orbit) {
    // Seen from straight above or below, "up" is the way that the horizon lies behind the target.
    const float a = glm::radians(orbit.azimuth);
    const bool vertical = std::abs(directionTowards(orbit.azimuth, orbit.elevation).z) > 0.9999f;
    const glm::vec3 up = vertical ? glm::vec3(-std::sin(a), std::cos(a), 0) : glm::vec3(0, 0, 1);
    return glm::lookAt(eyeOf(orbit), orbit.target, up);
}

}  // namespace

bool fallsWithDistance(const DepthConvention& convention) noexcept {
    return convention.reversed != (convention.range.x > convention.range.y);
}

glm::vec3 directionTowards(float azimuth, float elevation) {
    const float a = glm::radians(azimuth);
    const float e = glm::radians(elevation);
    return {std::cos(e) * std::sin(a), -std::cos(e) * std::cos(a), std::sin(e)};
}

Camera perspectiveCamera(const OrbitCamera& orbit, float frameAspect,
                         const DepthConvention& depth) {
    const ClipPlanes planes = inOrder(clipPlanes(orbit), depth);
    const auto project =
        depth.zeroToOne ? glm::perspectiveRH_ZO<float> : glm::perspectiveRH_NO<float>;
    Camera camera;
    camera.viewProjection =
        project(glm::radians(orbit.fieldOfView), frameAspect, planes.near, planes.far) *
        viewOf(orbit);
    camera.eye = glm::vec4(eyeOf(orbit), 1.0f);
    camera.depth = depth;
    return camera;
}

Camera orthographicCamera(const OrbitCamera& orbit, float frameAspect,
                          const DepthConvention& depth) {
    const ClipPlanes planes = inOrder(clipPlanes(orbit), depth);
    const auto project = depth.zeroToOne ? glm::orthoRH_ZO<float> : glm::orthoRH_NO<float>;
    const float top = orbit.distance * std::tan(0.5f * glm::radians(orbit.fieldOfView));
    const float right = top * frameAspect;
    Camera camera;
    camera.viewProjection =
        project(-right, right, -top, top, planes.near, planes.far) * viewOf(orbit);
    camera.eye = glm::vec4(directionTowards(orbit.azimuth, orbit.elevation), 0.0f);
    camera.depth = depth;
    return camera;
}

Camera parallelRays(float azimuth, float elevation, float aspect) {
    Camera camera;
    camera.viewProjection = glm::ortho(-0.5f, 0.5f, -0.5f * aspect, 0.5f * aspect, -1.0f, 1.0f);
    camera.eye = glm::vec4(directionTowards(azimuth, elevation), 0.0f);
    return camera;
}

}  // namespace relievo::viewer
