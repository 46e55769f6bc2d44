#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/markdown.h"
#include "textures/atomic_file.h"

namespace relievo::bench {

/// Where a report goes besides the table on stdout; empty paths are not asked for.
struct ReportPaths {
    std::filesystem::path json;
    std::filesystem::path plot;
    std::filesystem::path markdown;
};

/// What the files hold.
struct Report {
    nlohmann::ordered_json json;
    Plot plot;
    std::string title;                    ///< of the Markdown
    std::vector<ReportSection> sections;  ///< likewise
};

/// The files of a report. They are created before the measurement, so that what would make a long
/// measurement useless fails at once, and appear whole or not at all.
class ReportFiles {
  public:
    /// Throws commands::UsageError when the plot is no `.svg` or `.png`, std::runtime_error when
    /// gnuplot is missing and textures::InputError when a file cannot be created.
    explicit ReportFiles(const ReportPaths& paths);

    /// Writes the files that were asked for.
    void write(const Report& report);

  private:
    std::optional<textures::AtomicFile> json_;
    std::optional<textures::AtomicFile> plot_;
    PlotFormat plotFormat_ = PlotFormat::Svg;
    std::optional<textures::AtomicFile> markdown_;
};

}  // namespace relievo::bench
