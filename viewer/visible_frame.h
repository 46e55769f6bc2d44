#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "gl/framebuffer.h"

namespace relievo::viewer {

/// What a pixel of a frame of several objects shows.
struct VisiblePixel {
    int object = -1;           ///< its number; −1 for the background
    glm::vec3 position{0.0f};  ///< of the visible point, in world space
    bool isLit = true;         ///< the frame's shadow map leaves it in the light
};

/// What a frame shows, rows from the top, and what it took.
struct VisibleFrame {
    int width = 0;
    int height = 0;
    std::vector<VisiblePixel> pixels;
    /// Of all searches of the frame together, those that later fragments hid included.
    std::uint64_t fetches = 0;
};

/// A framebuffer with the attachments that programs/visible.frag writes.
gl::Framebuffer makeVisibleTarget(int width, int height);

/// Reads what programs/visible.frag wrote to `target`, which was cleared to 0; without the lookups.
VisibleFrame readVisibleFrame(const gl::Framebuffer& target);

}  // namespace relievo::viewer
