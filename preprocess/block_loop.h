#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

#include "preprocess/apex_block.h"

namespace relievo::preprocess {

/// The part of a plane that a block covers.
struct BlockPlace {
    int left;
    int top;
    int width;
    int height;
    [[nodiscard]] std::size_t texels() const noexcept {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
};

/// Calls work(state of the thread, BlockPlace) for all blocks of a plane of this size, in parallel.
template <typename State, typename Work>
void forAllBlocks(int width, int height, tbb::enumerable_thread_specific<State>& states,
                  const Work& work) {
    const int columns = (width + kBlockSize - 1) / kBlockSize;
    const int rows = (height + kBlockSize - 1) / kBlockSize;
    tbb::parallel_for(0, columns * rows, [&](int block) {
        const int left = block % columns * kBlockSize;
        const int top = block / columns * kBlockSize;
        work(states.local(), BlockPlace{left, top, std::min(kBlockSize, width - left),
                                        std::min(kBlockSize, height - top)});
    });
}

/// Calls use(i, j, index in BlockValues) for the texels (i,j) of the plane that the block covers.
template <typename Use>
void forTexels(const BlockPlace& place, const Use& use) {
    for (int j = 0; j < place.height; ++j)
        for (int i = 0; i < place.width; ++i)
            use(place.left + i, place.top + j, blockIndex(i, j));
}

/// Adds up what the searches of all threads counted, when somebody wants to know.
template <typename State>
void collect(const tbb::enumerable_thread_specific<State>& states,
             SlopeSearchStatistics* statistics) {
    if (statistics != nullptr)
        for (const State& state : states)
            *statistics += state.search.statistics();
}

}  // namespace relievo::preprocess
