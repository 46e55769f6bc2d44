#pragma once

#include <CLI/CLI.hpp>

#include "bench/report_files.h"
#include "bench/search_benchmark.h"

namespace relievo::bench {

/// `relievo-bench search`: its options, and what it does with them.
class SearchCommand {
  public:
    /// Adds the subcommand to `app`. Parsing fills this object, so it must still be there then.
    explicit SearchCommand(CLI::App& app);
    SearchCommand(const SearchCommand&) = delete;
    SearchCommand& operator=(const SearchCommand&) = delete;

    /// Whether the parsed command line asks for it.
    [[nodiscard]] bool chosen() const { return command_->parsed(); }
    /// Measures, prints the table and writes the files that were asked for.
    void run() const;

  private:
    CLI::App* command_;
    SearchBenchmarkOptions options_;
    ReportPaths paths_;
};

}  // namespace relievo::bench
