#pragma once

#include <CLI/CLI.hpp>

#include "bench/bake_benchmark.h"
#include "bench/report_files.h"

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
    /// Measures, prints the table and writes the files that were asked for.
    void run() const;

  private:
    CLI::App* command_;
    BakeBenchmarkOptions options_;
    ReportPaths paths_;
};

}  // namespace relievo::bench
