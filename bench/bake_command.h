#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "bench/bake_benchmark.h"
#include "bench/edit_benchmark.h"
#include "bench/report_files.h"
#include "bench/search_benchmark.h"

namespace relievo::bench {

/// `relievo-bench bake`: its options, and what it does with them.
class BakeCommand {
  public:
    /// Adds the subcommand to `app`. Parsing fills this object, so it must still be there then.
    explicit BakeCommand(CLI::App& app);
    BakeCommand(const BakeCommand&) = delete;
    BakeCommand& operator=(const BakeCommand&) = delete;

    /// Whether the parsed command line asks for it.
    [[nodiscard]] bool chosen() const { return command_->parsed(); }
    /// Measures, prints the tables and writes the files that were asked for.
    void run() const;

  private:
    [[nodiscard]] std::vector<EditMeasurement> measureStrokes() const;
    [[nodiscard]] std::vector<SearchMeasurement> measureRays() const;

    CLI::App* command_;
    BakeBenchmarkOptions options_;
    int threads_ = 0;  // 0: all cores
    int strokes_ = 0;
    int rays_ = 0;
    ReportPaths paths_;
};

}  // namespace relievo::bench
