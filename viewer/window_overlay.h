#pragma once

#include "viewer/window_help.h"
#include "viewer/window_settings.h"

namespace relievo::viewer {

/// Draws a note of what is under way into the lower right corner of the picture. Call it within a
/// frame of ImGui.
void drawNote(const char* note, const PictureArea& area);

/// Draws what lies over the picture, along its edges: the names of the techniques, the line between
/// them, and a note while the exact hits are traced. Call it within a frame of ImGui.
void drawOverlay(const WindowSettings& settings, const PictureArea& area, bool isTracing);

}  // namespace relievo::viewer
