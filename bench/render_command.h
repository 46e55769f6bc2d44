#pragma once

#include <CLI/CLI.hpp>

#include "bench/render_benchmark.h"
#include "bench/report_files.h"

namespace relievo::bench {

/// `relievo-bench render`: its options, and what it does with them.
class RenderCommand {
  public:
    /// Adds the subcommand to `app`. Parsing fills this object, so it must still be there then.
    explicit RenderCommand(CLI::App& app);
    RenderCommand(const RenderCommand&) = delete;
    RenderCommand& operator=(const RenderCommand&) = delete;

    /// Whether the parsed command line asks for it.
    [[nodiscard]] bool chosen() const { return command_->parsed(); }
    /// Measures, prints the table and writes the files that were asked for.
    void run() const;

  private:
    CLI::App* command_;
    RenderBenchmarkOptions options_;
    PlotAgainst plotAgainst_ = PlotAgainst::Time;
    ReportPaths paths_;
};

}  // namespace relievo::bench
