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
        m_plot.emplace(paths.plot);
    }
    if (!paths.json.empty())
        m_json.emplace(paths.json);
}

void ReportFiles::write(const nlohmann::ordered_json& report, const Plot& plot) {
    if (m_json) {
        const std::string text = report.dump(2) + "\n";
        m_json->write(std::as_bytes(std::span(text)));
        m_json->commit();
    }
    if (m_plot) {
        drawPlot(plot, m_plot->path());
        m_plot->commit();
    }
}

}  // namespace relievo::bench
