#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace relievo::commands {

/// A progress bar with the time left, on stderr, for work of known size. It appears only on a
/// terminal, after one second, and not with --quiet; the destructor clears it. `advance` may be
/// called from any thread.
class Progress {
  public:
    /// `what` names the work ("cones"); `total` is its size in any unit.
    Progress(std::string what, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void advance(std::size_t done = 1);

  private:
    void draw(std::size_t done, double elapsedSeconds) const;

    std::string what_;
    std::size_t total_;
    bool visible_;
    std::atomic<std::size_t> done_{0};
    std::chrono::steady_clock::time_point start_;
    std::atomic<std::int64_t> lastFrame_;
};

/// "3 s", "2 min 05 s", "1 h 10 min": a duration as a person reads it; never negative.
std::string durationText(double seconds);

}  // namespace relievo::commands
