#pragma once

#include <optional>
#include <string>

#include "viewer/panel_layout.h"
#include "viewer/solid_frame.h"
#include "viewer/tessellation_count.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// What the panel shows besides the options.
struct SolidPanelReport {
    const SolidReadings& readings;
    const textures::ShapeMap* shape = nullptr;  ///< null for a scene
    std::optional<SceneTriangles> triangles;    ///< of a scene
    std::string message;                        ///< about the last picture saved, or empty
};

/// How far the sliders of offsets go to both sides, in tile widths.
inline constexpr float kMostOffset = 0.25f;

/// The right end of the slider of a shape's extension e, where it is kMostOffset: fixed, so that
/// the interface can be worked from outside.
WindowPoint extensionSliderEnd();

/// Draws the panel for a scene or a shape, `height` pixels high, and lets it change `options`.
PanelActions drawSolidPanel(ViewOptions& options, const SolidPanelReport& report, float height);

}  // namespace relievo::viewer
