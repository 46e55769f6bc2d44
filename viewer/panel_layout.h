#pragma once

#include "viewer/imgui_session.h"

namespace relievo::viewer {

/// The panel stands at the left edge of the window, over its whole height; the picture has the
/// rest.
inline constexpr int kPanelWidth = 320;

/// A place in the window, in pixels from its upper left.
struct WindowPoint {
    int x;
    int y;
};

/// The buttons that were pressed.
struct PanelActions {
    bool save = false;
    bool resetCamera = false;
    bool help = false;
};

/// Sizes in pixels; those of the style in imgui_session.cpp.
inline constexpr float kPaddingX = 12.0f;
inline constexpr float kPaddingY = 10.0f;
inline constexpr float kSpacing = 5.0f;
inline constexpr float kRowHeight = kFontSize + 2 * 3.0f;
inline constexpr float kSliderWidth = 150.0f;

}  // namespace relievo::viewer
