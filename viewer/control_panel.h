#pragma once

#include <array>
#include <string>

#include "viewer/comparison_frame.h"
#include "viewer/panel_layout.h"
#include "viewer/window_settings.h"

namespace relievo::viewer {

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

/// Draws the panel, `height` pixels high, and lets it change `settings`.
PanelActions drawControlPanel(WindowSettings& settings, const PanelReport& report, float height);

}  // namespace relievo::viewer
