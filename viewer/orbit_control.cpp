#include "viewer/orbit_control.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace relievo::viewer {
namespace {

constexpr float kDegreesPerFrame = 180.0f;
constexpr float kMaximumElevation = 89.9f;
constexpr float kZoomPerNotch = 0.9f;
constexpr float kFarthestFromFirst = 10.0f;

}  // namespace

OrbitCamera orbited(const OrbitCamera& camera, float dx, float dy, float frameHeight) {
    OrbitCamera result = camera;
    const float degreesPerPixel = kDegreesPerFrame / frameHeight;
    result.azimuth = std::remainder(camera.azimuth - dx * degreesPerPixel, 360.0f);
    result.elevation =
        std::clamp(camera.elevation + dy * degreesPerPixel, -kMaximumElevation, kMaximumElevation);
    return result;
}

OrbitCamera panned(const OrbitCamera& camera, float dx, float dy, float frameHeight) {
    const float azimuth = glm::radians(camera.azimuth);
    const glm::vec3 right(std::cos(azimuth), std::sin(azimuth), 0.0f);
    const glm::vec3 up = glm::cross(directionTowards(camera.azimuth, camera.elevation), right);
    const float unitsPerPixel =
        2.0f * camera.distance * std::tan(0.5f * glm::radians(camera.fieldOfView)) / frameHeight;
    OrbitCamera result = camera;
    result.target += unitsPerPixel * (dy * up - dx * right);
    return result;
}

ZoomLimits zoomLimitsAround(const OrbitCamera& first) {
    ZoomLimits limits;
    limits.nearest = std::min(limits.nearest, first.distance);
    limits.farthest = std::max(limits.farthest, kFarthestFromFirst * first.distance);
    return limits;
}

OrbitCamera zoomed(const OrbitCamera& camera, float notches, const ZoomLimits& limits) {
    OrbitCamera result = camera;
    result.distance = std::clamp(camera.distance * std::pow(kZoomPerNotch, notches), limits.nearest,
                                 limits.farthest);
    return result;
}

}  // namespace relievo::viewer
