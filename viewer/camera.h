#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace relievo::viewer {

/// What a program needs to know of the eye.
struct Camera {
    glm::mat4 viewProjection{1.0f};
    /// The eye's position (w = 1), or the direction towards it (w = 0) under parallel projection.
    glm::vec4 eye{0, 0, 1, 0};
};

/// An eye on a sphere around a target, z up. Angles in degrees.
struct OrbitCamera {
    float azimuth = 35.0f;      ///< 0 looks along +y, grows counter-clockwise seen from above
    float elevation = 40.0f;    ///< above the horizon, in [−90, 90]
    float distance = 1.8f;      ///< from the target, in world units, > 0
    float fieldOfView = 40.0f;  ///< vertical
    glm::vec3 target{0.0f};

    friend bool operator==(const OrbitCamera&, const OrbitCamera&) = default;
};

/// The perspective camera of `orbit` for a frame of the given width/height.
Camera perspectiveCamera(const OrbitCamera& orbit, float frameAspect);

/// Parallel view rays over the quad of surfaces::makeQuad with one tile and aspect ρ: every pixel
/// of the frame is a point of the tile, and all rays come from the same direction. It is not how a
/// scene looks but what a search has to do; measurements use it.
Camera parallelRays(float azimuth, float elevation, float aspect);

/// The unit vector towards (azimuth, elevation), in degrees: where the eye or the light stands.
glm::vec3 directionTowards(float azimuth, float elevation);

}  // namespace relievo::viewer
