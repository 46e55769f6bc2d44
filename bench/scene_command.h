#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "bench/report_files.h"
#include "bench/scene_benchmark.h"

namespace relievo::bench {

/// `relievo-bench scene`: its options, and what it does with them.
class SceneCommand {
  public:
    /// Adds the subcommand to `app`. Parsing fills this object, so it must still be there then.
    explicit SceneCommand(CLI::App& app);
    SceneCommand(const SceneCommand&) = delete;
    SceneCommand& operator=(const SceneCommand&) = delete;

    /// Whether the parsed command line asks for it.
    [[nodiscard]] bool chosen() const { return command_->parsed(); }
    /// Measures, prints the table and writes the files that were asked for.
    void run() const;

  private:
    CLI::App* command_;
    SceneBenchmarkOptions options_;
    std::filesystem::path picture_;
    ReportPaths paths_;
};

}  // namespace relievo::bench
