#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace relievo::tests {

/// A program that runs while the test goes on. It is killed with the object, and with the test.
class BackgroundProcess {
  public:
    /// Starts `command` (found through PATH, then its arguments; no shell) in `folder`. Its output
    /// goes nowhere, its errors where the test's go. Throws std::runtime_error.
    explicit BackgroundProcess(const std::vector<std::string>& command,
                               const std::filesystem::path& folder = ".");
    ~BackgroundProcess();
    BackgroundProcess(const BackgroundProcess&) = delete;
    BackgroundProcess& operator=(const BackgroundProcess&) = delete;

    /// The exit status (128 + the signal that killed it), or nothing while it runs.
    std::optional<int> status();

  private:
    pid_t child_ = -1;
    std::optional<int> status_;
};

/// How long a test waits for anything before it fails: long, for machines with much else to do.
inline constexpr std::chrono::seconds kPatience{60};

/// Waits until `condition` holds, at most kPatience; returns whether it does.
template <typename Condition>
bool waitUntil(Condition&& condition) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return true;
}

}  // namespace relievo::tests
