#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace relievo::bench {

/// One curve: points (x,y) in the order in which they are joined.
struct PlotSeries {
    std::string name;
    std::vector<std::pair<double, double>> points;
};

struct PlotPanel {
    std::string title;
    std::vector<PlotSeries> series;
};

/// Panels of one kind, laid out in rows, with logarithmic axes. A series of one name has one colour
/// in all panels. Points must be finite and positive.
struct Plot {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    int xLogarithmBase = 10;
    std::string keyPosition = "top left";  ///< of the names, inside each panel
    bool hasLegend = false;    ///< names stand once, in a panel of their own behind the others
    bool hasOneRange = false;  ///< all panels have the same y axis
    int columns = 0;           ///< panels in a row; 0 is about as many as there are rows
    std::vector<PlotPanel> panels;
};

/// The series of that name in the panel of that title, made at the end of either when missing.
PlotSeries& seriesOf(Plot& plot, const std::string& panelTitle, const std::string& seriesName);

enum class PlotFormat { Svg, Png };

/// What the name of a plot's file asks for by its end, `.svg` or `.png`; nothing for any other.
std::optional<PlotFormat> plotFormatOf(const std::filesystem::path& file);

/// Throws std::runtime_error when there is no gnuplot to run: to be called before measuring.
void requireGnuplot();

/// The gnuplot program that draws `plot` to `output`, data included.
std::string gnuplotScript(const Plot& plot, const std::filesystem::path& output,
                          PlotFormat format = PlotFormat::Svg);

/// Draws `plot` to `output`, whatever its name, by piping a script to gnuplot. Throws
/// std::runtime_error when gnuplot fails; its own message goes to stderr.
void drawPlot(const Plot& plot, const std::filesystem::path& output,
              PlotFormat format = PlotFormat::Svg);

}  // namespace relievo::bench
