#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/report_table.h"
#include "viewer/scene_errors.h"

namespace relievo::bench {

/// What to measure: a scene of several objects, shown by each technique, with and without skipping
/// hidden objects, and by relief mapping with more and more steps, until it is no more wrong than
/// the first technique with its last target.
struct SceneBenchmarkOptions {
    std::string scene = "hidden";                          ///< one of sceneNames()
    std::vector<std::string> techniques{"auto", "exact"};  ///< names of the technique registry
    int size = 256;                                        ///< the reliefs are size×size texels
    std::vector<double> pixelErrors{0.25, 0.1};            ///< targets of techniques that take one
    int frame = 240;  ///< pixels of the frame's height; a third more in width
};

struct SceneMeasurement {
    std::string technique;
    std::optional<double> pixelError;  ///< the target, of a technique that takes one
    std::optional<int> steps;          ///< the step budget where it was chosen
    bool skipsHidden = false;
    std::uint64_t fetches = 0;     ///< of the frame
    double fetchesPerPixel = 0.0;  ///< over the pixels of the frame
    viewer::SceneErrors errors;    ///< against the nearest exact hit of each pixel
};

/// The techniques in their order, and relief mapping last. Needs a current context.
std::vector<SceneMeasurement> measureScene(const SceneBenchmarkOptions& options);

/// One row a measurement; shares in per cent.
ReportTable sceneTable(const std::vector<SceneMeasurement>& measurements);

/// Mean shift against lookups, a curve for each technique with and without hidden objects.
Plot scenePlot(const std::vector<SceneMeasurement>& measurements);

/// Draws the scene by the first technique, in the light that it says, and writes the picture.
void writeScenePicture(const SceneBenchmarkOptions& options, const std::filesystem::path& file);

}  // namespace relievo::bench
