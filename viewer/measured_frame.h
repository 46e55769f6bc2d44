#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "gl/framebuffer.h"

namespace relievo::viewer {

/// What a search did at one pixel, and the ray it was given; float values as the shader had them.
struct MeasuredPixel {
    glm::vec3 hit{0.0f};  ///< (u,v,z)
    float t = 0.0f;       ///< along the ray
    int outcome = 0;      ///< RELIEVO_OUTCOME_… of shaders/relievo/constants.h
    int steps = 0;
    int fetches = 0;
    glm::vec3 origin{0.0f};     ///< (u,v,z) where the ray enters the relief
    glm::vec3 direction{0.0f};  ///< (du,dv,dz) per unit of t
    float end = 0.0f;           ///< t where the ray ends
    glm::vec3 normal{0, 0, 1};  ///< unit shading normal in the tile's metric
    /// Towards the light's centre (du,dv,dz) as its point sees it, and to two edges of its disc.
    glm::vec3 light{0.0f};
    glm::vec3 lift{0.0f};
    glm::vec3 side{0.0f};
    float lightShare = 1.0f;  ///< what gets there of it, 1 without shadows
    int shadowFetches = 0;
    bool covered = false;  ///< the surface covers this pixel
};

/// One frame of measurements, rows from the top.
struct MeasuredFrame {
    int width = 0;
    int height = 0;
    std::vector<MeasuredPixel> pixels;
};

/// Sums over the covered pixels of a frame. Exactly repeatable, unlike times.
struct WorkCounts {
    std::size_t pixels = 0;
    std::size_t exhausted = 0;  ///< searches that ran out of steps
    double meanSteps = 0.0;
    double meanFetches = 0.0;
};

/// A framebuffer with the attachments that programs/measured.frag writes.
gl::Framebuffer makeMeasuredTarget(int width, int height);

/// Reads what programs/measured.frag wrote to `target`.
MeasuredFrame readMeasuredFrame(const gl::Framebuffer& target);

WorkCounts countWork(const MeasuredFrame& frame);

}  // namespace relievo::viewer
