#pragma once

#include <array>
#include <string>

#include "viewer/comparison_frame.h"
#include "viewer/window_settings.h"

namespace relievo::viewer {

/// The panel stands at the left edge of the window, over its whole height; the picture has the
/// rest.
inline constexpr int kPanelWidth = 320;

/// A place in the window, in pixels from its upper left.
struct WindowPoint {
    int x;
    int y;
};

/// The middle of the closed list of techniques A, and of its entry `index` when it is open: fixed,
/// so that the interface can be worked from outside.
WindowPoint techniqueListCenter();
WindowPoint techniqueEntryCenter(int index);

/// What the panel shows besides the settings.
struct PanelReport {
    const std::array<PaneReadings, 2>& readings;
    int levelCount = 1;      ///< MIP levels of the file that is shown
    bool isTracing = false;  ///< exact hits are on their way
    float progress = 0.0f;   ///< of tracing, in [0,1]
    std::string message;     ///< about the last picture saved, or empty
};

/// The buttons that were pressed.
struct PanelActions {
    bool save = false;
    bool resetCamera = false;
    bool help = false;
};

/// Draws the panel, `height` pixels high, and lets it change `settings`.
PanelActions drawControlPanel(WindowSettings& settings, const PanelReport& report, float height);

}  // namespace relievo::viewer
