#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace relievo::tests {

/// How to run a program in a test.
struct ProcessOptions {
    std::filesystem::path folder;  ///< working folder; "" is the current one
    /// Send `signal` so long after the start, unless the program has ended by then.
    std::optional<std::chrono::milliseconds> signalAfter;
    /// Send `signal` as soon as this holds of what the program has printed on stdout, unless it has
    /// ended by then. It must come to that within a minute.
    std::function<bool(const std::string& output)> signalWhen;
    int signal = 2;  ///< SIGINT
    /// Limit in bytes on the size of every file that the program writes (RLIMIT_FSIZE), which makes
    /// a write fail like a full disk does, without the rights to mount one.
    std::optional<std::size_t> fileSizeLimit;
};

/// How a program ended and what it printed.
struct ProcessResult {
    int exitStatus = -1;  ///< -1 when a signal killed it
    int killedBy = 0;     ///< the signal that killed it, or 0
    std::string output;   ///< stdout
    std::string errors;   ///< stderr
};

/// Runs `command` (the program's path, then its arguments; no shell) to its end. Throws
/// std::runtime_error when it cannot be started, or does not come to where it is to be signalled.
ProcessResult runProcess(const std::vector<std::string>& command,
                         const ProcessOptions& options = {});

/// An empty folder that is removed with all it holds at the end of the scope.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    /// The path of `name` inside the folder.
    [[nodiscard]] std::string file(const std::string& name) const { return path_ / name; }
    /// The names of what the folder holds, sorted.
    [[nodiscard]] std::vector<std::string> list() const;

  private:
    std::filesystem::path path_;
};

/// The bytes of a file. Throws std::runtime_error when it cannot be read.
std::string readBytes(const std::filesystem::path& file);

}  // namespace relievo::tests
