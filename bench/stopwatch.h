#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace relievo::bench {

/// The time in seconds that `work` takes.
template <typename Work>
double secondsOf(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return elapsed.count();
}

/// The least time in seconds of `repeat` ≥ 1 runs of `work`: what else runs on the machine only
/// ever adds to it.
template <typename Work>
double leastSeconds(int repeat, const Work& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < repeat; ++run)
        least = std::min(least, secondsOf(work));
    return least;
}

}  // namespace relievo::bench
