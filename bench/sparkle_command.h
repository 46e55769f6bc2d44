#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "bench/report_files.h"
#include "bench/sparkle_benchmark.h"

namespace relievo::bench {

/// `relievo-bench sparkle`: its options, and what it does with them.
class SparkleCommand {
  public:
    /// Adds the subcommand to `app`. Parsing fills this object, so it must still be there then.
    explicit SparkleCommand(CLI::App& app);
    SparkleCommand(const SparkleCommand&) = delete;
    SparkleCommand& operator=(const SparkleCommand&) = delete;

    /// Whether the parsed command line asks for it.
    [[nodiscard]] bool chosen() const { return command_->parsed(); }
    /// Measures, prints the table and writes the files that were asked for.
    void run() const;

  private:
    CLI::App* command_;
    SparkleBenchmarkOptions options_;
    std::filesystem::path picture_;
    ReportPaths paths_;
};

}  // namespace relievo::bench
