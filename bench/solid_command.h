#pragma once

#include <CLI/CLI.hpp>

#include "bench/report_files.h"
#include "bench/solid_benchmark.h"

namespace relievo::bench {

/// `relievo-bench solid`: its options, and what it does with them.
class SolidCommand {
  public:
    /// Adds the subcommand to `app`. Parsing fills this object, so it must still be there then.
    explicit SolidCommand(CLI::App& app);
    SolidCommand(const SolidCommand&) = delete;
    SolidCommand& operator=(const SolidCommand&) = delete;

    /// Whether the parsed command line asks for it.
    [[nodiscard]] bool chosen() const { return command_->parsed(); }
    /// Measures, prints the table and writes the files that were asked for.
    void run() const;

  private:
    CLI::App* command_;
    SolidBenchmarkOptions options_;
    PlotAgainst plotAgainst_ = PlotAgainst::Time;
    ReportPaths paths_;
};

}  // namespace relievo::bench
