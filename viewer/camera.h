#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace relievo::viewer {

/// How distances from the eye become window depths.
struct DepthConvention {
    /// The projection takes depths to [0,1] (GL_ZERO_TO_ONE), not to [−1,1].
    bool zeroToOne = false;
    /// The projection takes the near plane to the upper end of that interval.
    bool reversed = false;
    /// Window depths of the interval's ends (glDepthRange), in [0,1]; the first may be the greater.
    glm::vec2 range{0.0f, 1.0f};
};

/// Whether what is farther has the lesser window depth.
bool fallsWithDistance(const DepthConvention& convention) noexcept;

/// What a program needs to know of the eye.
struct Camera {
    glm::mat4 viewProjection{1.0f};
    /// The eye's position (w = 1), or the direction towards it (w = 0) under parallel projection.
    glm::vec4 eye{0, 0, 1, 0};
    DepthConvention depth;  ///< of viewProjection
};

/// An eye on a sphere around a target, z up. Angles in degrees.
struct OrbitCamera {
    float azimuth = 35.0f;      ///< 0 looks along +y, grows counter-clockwise seen from above
    float elevation = 40.0f;    ///< above the horizon, in [−90, 90]
    float distance = 1.8f;      ///< from the target, in world units, > 0
    float fieldOfView = 40.0f;  ///< vertical
    glm::vec3 target{0.0f};
    /// What is no further behind the target than this is shown, however near the eye comes.
    float reach = 20.0f;

    friend bool operator==(const OrbitCamera&, const OrbitCamera&) = default;
};

/// The perspective camera of `orbit` for a frame of the given width/height.
Camera perspectiveCamera(const OrbitCamera& orbit, float frameAspect,
                         const DepthConvention& depth = {});

/// The parallel projection that shows the target of `orbit` as large as its perspective does: of an
/// eye, or of a light that is far away.
Camera orthographicCamera(const OrbitCamera& orbit, float frameAspect,
                          const DepthConvention& depth = {});

/// Parallel view rays over the quad of surfaces::makeQuad with one tile and aspect ρ: every pixel
/// of the frame is a point of the tile, and all rays come from the same direction. It is not how a
/// scene looks but what a search has to do; measurements use it.
Camera parallelRays(float azimuth, float elevation, float aspect);

/// The unit vector towards (azimuth, elevation), in degrees: where the eye or the light stands.
glm::vec3 directionTowards(float azimuth, float elevation);

}  // namespace relievo::viewer
