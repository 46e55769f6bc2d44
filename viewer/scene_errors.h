#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "viewer/camera.h"
#include "viewer/exact_scene.h"
#include "viewer/visible_frame.h"

namespace relievo::viewer {

/// How wrong a frame of several objects is. Shifts are those of the points of a surface that pixels
/// show, as seen, in pixels.
struct SceneErrors {
    std::size_t pixels = 0;         ///< that show an object, in truth or in the frame
    double wrongObjectShare = 0.0;  ///< show another object than the nearest, or none
    /// Out of place by over a pixel: a point of the nearest object, or another object that is not
    /// nearest in any of the pixels around either.
    double wrongShare = 0.0;
    double meanShift = 0.0;  ///< where the object is the right one
};

/// Compares a frame with what traceScene found for the same camera and size.
SceneErrors compareScene(const VisibleFrame& frame, std::span<const std::optional<ExactHit>> exact,
                         const Camera& camera);

}  // namespace relievo::viewer
