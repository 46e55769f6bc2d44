#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "bench/sheet_view.h"

namespace relievo::bench {

/// `relievo-bench sheet`: its options, and what it does with them.
class SheetCommand {
  public:
    /// Adds the subcommand to `app`. Parsing fills this object, so it must still be there then.
    explicit SheetCommand(CLI::App& app);
    SheetCommand(const SheetCommand&) = delete;
    SheetCommand& operator=(const SheetCommand&) = delete;

    /// Whether the parsed command line asks for it.
    [[nodiscard]] bool chosen() const { return command_->parsed(); }
    /// Draws the pictures and writes the file.
    void run() const;

  private:
    /// Throws commands::UsageError for an option that does nothing for this sheet.
    void checkOptions() const;
    [[nodiscard]] viewer::Picture makeSheet() const;

    CLI::App* command_;
    std::string subject_ = "techniques";
    SheetOptions options_;
    std::vector<std::string> techniques_;
    std::string figures_ = "all";
    std::filesystem::path output_;
};

}  // namespace relievo::bench
