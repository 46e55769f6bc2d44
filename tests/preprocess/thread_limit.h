#pragma once

#include <tbb/global_control.h>

#include <cstddef>

namespace relievo::preprocess {

/// What `build` returns on so many threads.
template <typename Build>
auto onThreads(std::size_t threads, const Build& build) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return build();
}

}  // namespace relievo::preprocess
