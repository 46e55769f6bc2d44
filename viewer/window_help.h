#pragma once

#include <span>

namespace relievo::viewer {

/// The picture's place in the window, in pixels of the window system (not of the framebuffer).
struct PictureArea {
    float left = 0.0f;
    float width = 0.0f;
    float height = 0.0f;
};

/// A line of the list of keys.
struct KeyHelp {
    const char* keys;
    const char* meaning;
};

/// Draws the list of `keys`, and then those that every window has, in the middle of the picture.
/// Call it within a frame of ImGui.
void drawHelp(const PictureArea& area, std::span<const KeyHelp> keys);

}  // namespace relievo::viewer
