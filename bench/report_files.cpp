#include "bench/report_files.h"

#include <fmt/format.h>

#include <span>
#include <string>

#include "commands/program.h"

namespace relievo::bench {

ReportFiles::ReportFiles(const ReportPaths& paths) {
    if (!paths.plot.empty()) {
        if (paths.plot.extension() != ".svg")
            throw commands::UsageError(
                fmt::format("--plot {}: plots are SVG, expected a name that ends in .svg",
                            paths.plot.string()));
        requireGnuplot();
        plot_.emplace(paths.plot);
    }
    if (!paths.json.empty())
        json_.emplace(paths.json);
}

void ReportFiles::write(const nlohmann::ordered_json& report, const Plot& plot) {
    if (json_) {
        const std::string text = report.dump(2) + "\n";
        json_->writeAt(0, std::as_bytes(std::span(text)));
        json_->commit();
    }
    if (plot_) {
        drawPlot(plot, plot_->path());
        plot_->commit();
    }
}

}  // namespace relievo::bench
