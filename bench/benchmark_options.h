#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bench/render_benchmark.h"
#include "bench/report_files.h"
#include "gl/context.h"

namespace relievo::bench {

/// Adds an option that takes a list, separated by commas, of the names that `chosen` holds, which
/// are also the default.
void addNamesOption(CLI::App& command, const std::string& option, std::vector<std::string>& chosen,
                    const std::string& description);

/// Adds `--samples`, by default all generated reliefs.
void addSamplesOption(CLI::App& command, std::vector<std::string>& samples);

/// Adds `--repeat`.
void addRepeatOption(CLI::App& command, int& repeat);

/// Adds `--backend`.
void addBackendOption(CLI::App& command, gl::Backend& backend);

/// Adds `--plot-against`.
void addPlotAgainstOption(CLI::App& command, PlotAgainst& against);

/// Adds `--json`, `--markdown` and `--plot`.
void addReportOptions(CLI::App& command, ReportPaths& paths);

}  // namespace relievo::bench
