#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

namespace relievo::commands {

/// A progress bar with the time left, on stderr, for work of known size. It appears only on a
/// terminal, after one second, and not with --quiet. `advance` may be called from any thread.
class Progress {
  public:
    Progress(std::string what, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void advance(std::size_t done = 1);

  private:
    std::string what_;
    std::size_t total_;
    std::atomic<std::size_t> done_{0};
    std::chrono::steady_clock::time_point start_;
    std::atomic<std::int64_t> lastDrawn_{-1};
};

}  // namespace relievo::commands
