#include "commands/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "commands/program.h"

namespace relievo::commands {
namespace {

constexpr double kFrameSeconds = 0.2;
constexpr std::int64_t kFirstFrame = 5;  // one second
constexpr std::size_t kBarWidth = 30;

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(std::max<std::size_t>(total, 1)),
      visible_(!isQuiet() && isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      lastFrame_(kFirstFrame - 1) {}

Progress::~Progress() {
    if (visible_ && lastFrame_ >= kFirstFrame)
        fmt::print(stderr, "\r\033[K");
}

void Progress::advance(std::size_t done) {
    const std::size_t now = done_.fetch_add(done, std::memory_order_relaxed) + done;
    if (!visible_)
        return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const auto frame = static_cast<std::int64_t>(elapsed.count() / kFrameSeconds);
    std::int64_t last = lastFrame_.load();
    // Of the threads that arrive within one frame, only the one that moves lastFrame_ draws.
    if (frame > last && lastFrame_.compare_exchange_strong(last, frame))
        draw(std::min(now, total_), elapsed.count());
}

void Progress::draw(std::size_t done, double elapsedSeconds) const {
    const double share = static_cast<double>(done) / static_cast<double>(total_);
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(kBarWidth));
    const std::string left =
        done == 0 ? "" : durationText(elapsedSeconds * (1.0 - share) / share) + " left";
    const std::string line =
        fmt::format("\r{} [{}{}] {:3.0f} %  {}\033[K", what_, std::string(filled, '#'),
                    std::string(kBarWidth - filled, '.'), 100 * share, left);
    std::fwrite(line.data(), 1, line.size(), stderr);
}

std::string durationText(double seconds) {
    const auto whole = static_cast<std::int64_t>(std::ceil(std::clamp(seconds, 0.0, 1e9)));
    if (whole < 60)
        return fmt::format("{} s", whole);
    if (whole < 3600)
        return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace relievo::commands
