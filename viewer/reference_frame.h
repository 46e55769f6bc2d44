#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "reference/error_metrics.h"
#include "textures/depth_map.h"
#include "viewer/measured_frame.h"

namespace relievo::viewer {

/// The exact first hit of one pixel's ray.
struct ReferencePixel {
    bool covered = false;
    bool hit = false;
    double t = 0.0;
    glm::dvec3 position{0.0};    ///< (u,v,z)
    glm::dvec3 normal{0, 0, 1};  ///< unit, in the tile's metric at the depth scale
    double lightShare = 1.0;     ///< what gets to the hit of the light, 1 without shadows
};

/// The exact answer for every pixel of a frame, rows from the top.
struct ReferenceFrame {
    int width = 0;
    int height = 0;
    std::vector<ReferencePixel> pixels;
    int lightRays = 0;  ///< to the disc of the light from each hit; 0: there are no shadows
};

/// Traces every ray of `frame` in double precision against the bilinear surface of `map`, within
/// `window` (minimum u, v, maximum u, v), on all cores. Only the rays of the frame matter, not the
/// technique that it measured. With `lightRays` above 0 the light of `frame` casts shadows, which
/// take so many rays a hit (one when the light is a point).
ReferenceFrame traceReference(const MeasuredFrame& frame, const textures::DepthMap& map,
                              const glm::vec4& window, double depthScale, int lightRays = 0);

/// The hits as the texture that givenHitsTechnique() reads: RGBA floats (u, v, z, t), t = −1 for a
/// miss, rows from the bottom as OpenGL counts fragments.
std::vector<float> givenHitTexels(const ReferenceFrame& reference);

/// The shares of the light as the texture that materials::givenShadowMethod() reads, likewise.
std::vector<float> givenVisibilityTexels(const ReferenceFrame& reference);

/// One comparison a covered pixel, in the order of the pixels. Both frames must have one size.
std::vector<reference::HitComparison> compareFrames(const MeasuredFrame& frame,
                                                    const ReferenceFrame& reference,
                                                    const textures::DepthMap& map,
                                                    double depthScale);

}  // namespace relievo::viewer
