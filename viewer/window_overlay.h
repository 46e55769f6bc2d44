#pragma once

#include "viewer/window_help.h"
#include "viewer/window_settings.h"

namespace relievo::viewer {

/// Draws what lies over the picture, along its edges: the names of the techniques, the line between
/// them, and a note while the exact hits are traced. Call it within a frame of ImGui.
void drawOverlay(const WindowSettings& settings, const PictureArea& area, bool isTracing);

}  // namespace relievo::viewer
