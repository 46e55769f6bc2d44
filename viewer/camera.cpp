#include "viewer/camera.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace relievo::viewer {

glm::vec3 directionTowards(float azimuth, float elevation) {
    const float a = glm::radians(azimuth);
    const float e = glm::radians(elevation);
    return {std::cos(e) * std::sin(a), -std::cos(e) * std::cos(a), std::sin(e)};
}

Camera perspectiveCamera(const OrbitCamera& orbit, float frameAspect) {
    const glm::vec3 towardsEye = directionTowards(orbit.azimuth, orbit.elevation);
    const glm::vec3 eye = orbit.target + orbit.distance * towardsEye;
    // Seen from straight above or below, "up" is the way that the horizon lies behind the target.
    const float a = glm::radians(orbit.azimuth);
    const bool vertical = std::abs(towardsEye.z) > 0.9999f;
    const glm::vec3 up = vertical ? glm::vec3(-std::sin(a), std::cos(a), 0) : glm::vec3(0, 0, 1);
    const float near = std::max(0.01f, orbit.distance * 0.02f);
    const float far = orbit.distance + 20.0f;
    Camera camera;
    camera.viewProjection =
        glm::perspective(glm::radians(orbit.fieldOfView), frameAspect, near, far) *
        glm::lookAt(eye, orbit.target, up);
    camera.eye = glm::vec4(eye, 1.0f);
    return camera;
}

Camera parallelRays(float azimuth, float elevation, float aspect) {
    Camera camera;
    camera.viewProjection = glm::ortho(-0.5f, 0.5f, -0.5f * aspect, 0.5f * aspect, -1.0f, 1.0f);
    camera.eye = glm::vec4(directionTowards(azimuth, elevation), 0.0f);
    return camera;
}

}  // namespace relievo::viewer
