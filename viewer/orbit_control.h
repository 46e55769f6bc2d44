#pragma once

#include "viewer/camera.h"

namespace relievo::viewer {

/// How the mouse moves an eye. Distances on the screen are in pixels, x to the right and y down;
/// `frameHeight` is the height of the picture in pixels.

/// The scene follows the pointer: half a frame's height is a quarter turn. The elevation stays
/// within ±89.9°, where "up" still means something.
OrbitCamera orbited(const OrbitCamera& camera, float dx, float dy, float frameHeight);

/// Shifts the target in the picture's plane by as much as the point under the pointer moves.
OrbitCamera panned(const OrbitCamera& camera, float dx, float dy, float frameHeight);

/// How near the target the eye may come, and how far from it; in world units.
struct ZoomLimits {
    float nearest = 0.05f;
    float farthest = 50.0f;
};

/// Limits for a scene that `first` shows well: the usual ones, and farther for one that is seen
/// from afar.
ZoomLimits zoomLimitsAround(const OrbitCamera& first);

/// Moves the eye towards the target by `notches` of the mouse wheel (away from it when negative),
/// each by a tenth of the distance, within the limits.
OrbitCamera zoomed(const OrbitCamera& camera, float notches, const ZoomLimits& limits = {});

}  // namespace relievo::viewer
