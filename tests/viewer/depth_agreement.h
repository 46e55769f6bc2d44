#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "viewer/camera.h"
#include "viewer/exact_scene.h"

namespace relievo::viewer {

/// How far off the window depth of a point may be that is computed in floats, in a scene whose
/// lengths are under `length`: clip.z and clip.w are sums of four products, each off by no more
/// than 4ε of the sum of the products' absolute values (Higham, Accuracy and Stability, ch. 3), and
/// the point itself by those of the surface's interpolation, of the ray and of the hit's t, 16ε of
/// the length.
double depthBound(const Camera& camera, const glm::dvec3& position, double length = 4.0);

struct DepthAgreement {
    std::size_t compared = 0;
    std::size_t differing = 0;  ///< one of them has a hit and the other has not
    std::size_t beyond = 0;     ///< off by more than the bound
    double worst = 0.0;         ///< greatest difference as a multiple of the bound
};

/// Window depths of a frame that was cleared to the farthest depth, against exact ones.
DepthAgreement compareDepths(std::span<const float> depths,
                             std::span<const std::optional<ExactHit>> hits, const Camera& camera,
                             double length = 4.0);

}  // namespace relievo::viewer
