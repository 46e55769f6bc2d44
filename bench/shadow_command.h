#pragma once

#include <CLI/CLI.hpp>

#include "bench/report_files.h"
#include "bench/shadow_benchmark.h"

namespace relievo::bench {

/// `relievo-bench shadow`: its options, and what it does with them.
class ShadowCommand {
  public:
    /// Adds the subcommand to `app`. Parsing fills this object, so it must still be there then.
    explicit ShadowCommand(CLI::App& app);
    ShadowCommand(const ShadowCommand&) = delete;
    ShadowCommand& operator=(const ShadowCommand&) = delete;

    /// Whether the parsed command line asks for it.
    [[nodiscard]] bool chosen() const { return command_->parsed(); }
    /// Measures, prints the table and writes the files that were asked for.
    void run() const;

  private:
    CLI::App* command_;
    ShadowBenchmarkOptions options_;
    ReportPaths paths_;
};

}  // namespace relievo::bench
