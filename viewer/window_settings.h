#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "materials/technique_registry.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// How the window compares technique A with technique B or with the exact hits.
enum class ComparisonMode {
    Single,      ///< A alone
    SideBySide,  ///< A on the left, B on the right, each with a picture of its own
    Split,       ///< one picture, A to the left and B to the right of a line that can be dragged
    HeatMap,     ///< the error of A against the exact hits
};
inline constexpr std::array<std::string_view, 4> kComparisonModeNames = {"single", "side by side",
                                                                         "split", "error of A"};

/// All that decides what the window shows: two equal settings make the same picture.
struct WindowSettings {
    /// The scene, as the command line gave it and the panel changed it; its parameters hold those
    /// of the sliders too.
    ViewOptions options;
    std::size_t file = 0;    ///< index in options.files
    std::string techniqueA;  ///< of the registry, or kReferenceName
    std::string techniqueB;
    ComparisonMode mode = ComparisonMode::Single;
    float split = 0.5f;          ///< where the line stands, of the picture's width
    bool measureErrors = false;  ///< compare what is shown with the exact hits

    friend bool operator==(const WindowSettings&, const WindowSettings&) = default;
};

/// What `options` ask for: the first technique as A, the second one (or the exact reference) as B,
/// side by side when there are two.
WindowSettings makeWindowSettings(const ViewOptions& options);

/// The names that A and B can take, in the order of the lists: the registry, then kReferenceName.
std::vector<std::string_view> techniqueChoices();

/// The title of one of techniqueChoices().
std::string_view techniqueTitle(std::string_view name);

/// Whether B is in the picture.
bool showsSecond(const WindowSettings& settings);

/// Whether the picture or its readings need the exact hits.
bool needsReference(const WindowSettings& settings);

/// The value under `options` of a parameter of the technique of that name, "" for one of the shadow
/// method: the last of options.parameters that concerns it, or the default.
double parameterValue(const ViewOptions& options, std::string_view technique,
                      const materials::TechniqueParameter& parameter);

/// Makes `value` the one that parameterValue returns, without changing other techniques.
void setParameterValue(ViewOptions& options, std::string_view technique,
                       const materials::TechniqueParameter& parameter, double value);

}  // namespace relievo::viewer
