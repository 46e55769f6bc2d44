#pragma once

#include <string>

#include "viewer/comparison_frame.h"
#include "viewer/window_settings.h"

namespace relievo::viewer {

/// The picture's place in the window, in pixels of the window system (not of the framebuffer).
struct PictureArea {
    float left = 0.0f;
    float width = 0.0f;
    float height = 0.0f;
};

/// Draws what lies over the picture, along its edges: the names of the techniques, the line between
/// them, and a note while the exact hits are traced. Call it within a frame of ImGui.
void drawOverlay(const WindowSettings& settings, const PictureArea& area, bool isTracing);

/// Draws the list of keys in the middle of the picture.
void drawHelp(const PictureArea& area);

}  // namespace relievo::viewer
