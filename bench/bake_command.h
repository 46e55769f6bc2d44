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
    [[nodiscard]] bool chosen() const { return m_command->parsed(); }
    /// Measures, prints the table and writes the files that were asked for.
    void run() const;

  private:
    CLI::App* m_command;
    BakeBenchmarkOptions m_options;
    ReportPaths m_paths;
};

}  // namespace relievo::bench
