#include "bench/report_files.h"

#include <fmt/format.h>

#include <span>
#include <string>

#include "commands/program.h"

namespace relievo::bench {

namespace {

void writeText(textures::AtomicFile& file, const std::string& text) {
    file.writeAt(0, std::as_bytes(std::span(text)));
    file.commit();
}

}  // namespace

ReportFiles::ReportFiles(const ReportPaths& paths) {
    if (!paths.plot.empty()) {
        const std::optional<PlotFormat> format = plotFormatOf(paths.plot);
        if (!format)
            throw commands::UsageError(fmt::format(
                "--plot {}: expected a name that ends in .svg or .png", paths.plot.string()));
        plotFormat_ = *format;
        requireGnuplot();
        plot_.emplace(paths.plot);
    }
    if (!paths.json.empty())
        json_.emplace(paths.json);
    if (!paths.markdown.empty())
        markdown_.emplace(paths.markdown);
}

void ReportFiles::write(const Report& report) {
    if (json_)
        writeText(*json_, report.json.dump(2) + "\n");
    if (markdown_)
        writeText(*markdown_, markdownDocument(report.title, report.sections));
    if (plot_) {
        drawPlot(report.plot, plot_->path(), plotFormat_);
        plot_->commit();
    }
}

}  // namespace relievo::bench
