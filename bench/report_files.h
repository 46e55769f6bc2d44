#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/gnuplot.h"
#include "textures/atomic_file.h"

namespace relievo::bench {

/// Where a report goes besides the table on stdout; empty paths are not asked for.
struct ReportPaths {
    std::filesystem::path json;
    std::filesystem::path plot;
};

/// The files of a report. They are created before the measurement, so that what would make a long
/// measurement useless fails at once, and appear whole or not at all.
class ReportFiles {
  public:
    /// Throws commands::UsageError when the plot is no `.svg`, std::runtime_error when gnuplot is
    /// missing and textures::InputError when a file cannot be created.
    explicit ReportFiles(const ReportPaths& paths);

    /// Writes the files that were asked for.
    void write(const nlohmann::ordered_json& report, const Plot& plot);

  private:
    std::optional<textures::AtomicFile> json_;
    std::optional<textures::AtomicFile> plot_;
};

}  // namespace relievo::bench
