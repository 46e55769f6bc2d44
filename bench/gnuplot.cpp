#include "bench/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace relievo::bench {

namespace {

constexpr int kPanelWidth = 420;
constexpr int kPanelHeight = 320;
constexpr int kTitleHeight = 40;

/// A string of gnuplot in single quotes, in which only the quote itself is special.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

std::vector<std::string> seriesNames(const Plot& plot) {
    std::vector<std::string> names;
    for (const PlotPanel& panel : plot.panels)
        for (const PlotSeries& series : panel.series)
            if (std::find(names.begin(), names.end(), series.name) == names.end())
                names.push_back(series.name);
    return names;
}

std::string panelScript(const PlotPanel& panel, std::size_t number,
                        const std::vector<std::string>& names) {
    std::string data;
    std::vector<std::string> curves;
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
        const PlotSeries& series = panel.series[s];
        if (series.points.empty())
            continue;
        const std::string block = fmt::format("$data{}_{}", number, s);
        data += fmt::format("{} << END\n", block);
        for (const auto& [x, y] : series.points)
            data += fmt::format("{} {}\n", x, y);
        data += "END\n";
        const auto colour = std::find(names.begin(), names.end(), series.name) - names.begin() + 1;
        curves.push_back(fmt::format("{} with linespoints linetype {} title {}", block, colour,
                                     quoted(series.name)));
    }
    if (curves.empty())  // gnuplot has no empty panels; the cell of the layout is left free
        return "set multiplot next\n";
    return fmt::format("{}set title {}\nplot {}\n", data, quoted(panel.title),
                       fmt::join(curves, ", \\\n     "));
}

/// A panel with nothing but the names of all series.
std::string legendScript(const std::vector<std::string>& names) {
    std::vector<std::string> curves;
    for (std::size_t k = 0; k < names.size(); ++k)
        curves.push_back(
            fmt::format("NaN with linespoints linetype {} title {}", k + 1, quoted(names[k])));
    return fmt::format(
        "set key on center center font ',11'\nunset border\nunset tics\nunset xlabel\nunset "
        "ylabel\nset title ''\nset xrange [1:2]\nset yrange [1:2]\nplot {}\n",
        fmt::join(curves, ", \\\n     "));
}

/// The whole decades that hold all points of all panels.
std::string commonRange(const Plot& plot) {
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0.0;
    for (const PlotPanel& panel : plot.panels)
        for (const PlotSeries& series : panel.series)
            for (const auto& [x, y] : series.points) {
                least = std::min(least, y);
                greatest = std::max(greatest, y);
            }
    return fmt::format("set yrange [{}:{}]\n", std::pow(10.0, std::floor(std::log10(least))),
                       std::pow(10.0, std::ceil(std::log10(greatest))));
}

}  // namespace

PlotSeries& seriesOf(Plot& plot, const std::string& panelTitle, const std::string& seriesName) {
    auto panel = std::ranges::find(plot.panels, panelTitle, &PlotPanel::title);
    if (panel == plot.panels.end())
        panel = plot.panels.insert(panel, {panelTitle, {}});
    auto series = std::ranges::find(panel->series, seriesName, &PlotSeries::name);
    if (series == panel->series.end())
        series = panel->series.insert(series, {seriesName, {}});
    return *series;
}

void requireGnuplot() {
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0)
        throw std::runtime_error(
            "--plot needs the program gnuplot, which cannot be run (Debian package gnuplot-nox)");
}

std::optional<PlotFormat> plotFormatOf(const std::filesystem::path& file) {
    if (file.extension() == ".svg")
        return PlotFormat::Svg;
    if (file.extension() == ".png")
        return PlotFormat::Png;
    return std::nullopt;
}

std::string gnuplotScript(const Plot& plot, const std::filesystem::path& output,
                          PlotFormat format) {
    const std::vector<std::string> names = seriesNames(plot);
    const bool hasLegend = plot.hasLegend && !names.empty();
    const auto panels =
        static_cast<int>(std::max<std::size_t>(plot.panels.size() + (hasLegend ? 1 : 0), 1));
    const int square = static_cast<int>(std::ceil(std::sqrt(panels)));
    const int columns = plot.columns > 0 ? plot.columns : square;
    const int rows = (panels + columns - 1) / columns;
    std::string script = fmt::format(
        "set terminal {} noenhanced size {},{} background 'white' font 'sans,{}'\n"
        // Otherwise the ninth curve has the colour of the first.
        "set linetype 9 linecolor rgb '#8b5a2b' pointtype 9\n"
        "set linetype 10 linecolor rgb '#888888' pointtype 10\n"
        "set output {}\n"
        "set multiplot layout {},{} title {}\n"
        "set logscale x {}\nset logscale y\nset grid\nset key {} font ',9'\n"
        "set format '%g'\nset xlabel {}\nset ylabel {}\n",
        format == PlotFormat::Svg ? "svg" : "pngcairo", columns * kPanelWidth,
        rows * kPanelHeight + kTitleHeight, format == PlotFormat::Svg ? 11 : 9,
        quoted(output.string()), rows, columns, quoted(plot.title), plot.xLogarithmBase,
        plot.keyPosition, quoted(plot.xLabel), quoted(plot.yLabel));
    if (plot.hasOneRange && !names.empty())
        script += commonRange(plot);
    if (hasLegend)
        script += "unset key\n";
    for (std::size_t p = 0; p < plot.panels.size(); ++p)
        script += panelScript(plot.panels[p], p, names);
    if (hasLegend)
        script += legendScript(names);
    return script + "unset multiplot\nunset output\n";
}

void drawPlot(const Plot& plot, const std::filesystem::path& output, PlotFormat format) {
    const std::string script = gnuplotScript(plot, output, format);
    // A gnuplot that gives up early closes the pipe: that is for its exit status to say, not for
    // SIGPIPE to end this program.
    const auto previous = std::signal(SIGPIPE, SIG_IGN);
    std::FILE* const pipe = ::popen("gnuplot -d >/dev/null", "w");
    if (pipe != nullptr)
        std::fwrite(script.data(), 1, script.size(), pipe);
    const int status = pipe != nullptr ? ::pclose(pipe) : -1;
    std::signal(SIGPIPE, previous);
    if (status != 0)
        throw std::runtime_error("gnuplot failed to draw the plot");
}

}  // namespace relievo::bench
