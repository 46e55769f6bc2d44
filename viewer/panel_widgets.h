#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "materials/technique_registry.h"
#include "viewer/panel_layout.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// What panels are put together from.

inline const ImVec4 kWarning{1.0f, 0.62f, 0.35f, 1.0f};
inline const ImVec4 kQuiet{0.62f, 0.62f, 0.64f, 1.0f};

/// Begins a panel `height` pixels high.
void beginPanel(float height);
/// Ends it with the buttons of every panel and a message, which may be empty.
PanelActions endPanel(const std::string& message);

void heading(const char* text);

/// A heading that hides what is below it when it is clicked. Returns whether that is shown.
bool section(const char* text, ImGuiTreeNodeFlags flags = 0);

/// A text that stands out, over as many lines as it needs; nothing for an empty one.
void warning(const std::string& text);

/// A slider as wide as all are. Returns whether it changed `value`.
bool slider(const char* name, float& value, float least, float most, const char* format,
            ImGuiSliderFlags flags = 0);

/// The slider of a technique's parameter, or with the technique "" of one of the shadow method.
void parameterSlider(ViewOptions& options, std::string_view technique,
                     const materials::TechniqueParameter& parameter);

/// Where the light is.
void lightSliders(ViewOptions& options);

/// How the surface answers it.
void shadingModel(ViewOptions& options);

}  // namespace relievo::viewer
