#include "preprocess/relaxed_cones.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "preprocess/crest_search.h"
#include "preprocess/crest_tree.h"
#include "preprocess/near_crests.h"
#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using Advance = std::function<void(std::size_t)>;

// Slopes are products and quotients of a handful of floats; depths between samples are rounded to
// floats of a depth up to 1, over an eighth of a texel.
constexpr double kSlopeRounding = 3e-7;
constexpr double kDepthRounding = 3e-6;

struct State {
    CrestSearch search;
    NearCrests near;
    CrestBlock block;
    BlockValues slopes;

    State(const DepthMap& map, const Plane& depths, const CrestTree& tree, CrestLeaves leaves)
        : search(map, depths, tree, leaves), near(map.texelAspect) {}

    [[nodiscard]] SlopeSearchStatistics work() const {
        SlopeSearchStatistics sum = search.statistics();
        sum.samples += near.pairs();
        return sum;
    }
};

CrestBlock& goTo(State& state, const DepthMap& map, int block) {
    const int columns = (map.width() + kBlockSize - 1) / kBlockSize;
    state.block.left = block % columns * kBlockSize;
    state.block.top = block / columns * kBlockSize;
    state.block.width = std::min(kBlockSize, map.width() - state.block.left);
    state.block.height = std::min(kBlockSize, map.height() - state.block.top);
    return state.block;
}

void findTexelSlopes(State& state, const DepthMap& map) {
    CrestBlock& block = state.block;
    block.known.fill(0.0f);
    for (int j = 0; j < block.height; ++j)
        for (int i = 0; i < block.width; ++i)
            for (BlockValues& depth : block.depth)
                depth[blockIndex(i, j)] = map.depth.at(block.left + i, block.top + j);
    state.search.find(block, state.slopes);
}

void findBilinearSlopes(State& state, const DepthMap& map) {
    CrestBlock& block = state.block;
    state.near.begin(map, block.left, block.top);
    state.near.findCornerDepths(block.depth);
    state.near.findAttained(block.known);
    state.search.find(block, state.slopes);
    state.near.refine(block.width, block.height, state.slopes);
}

void storeRatios(const State& state, double depthRounding, Plane& ratio) {
    for (int j = 0; j < state.block.height; ++j)
        for (int i = 0; i < state.block.width; ++i) {
            const double slope = state.slopes[blockIndex(i, j)];
            const double safe = slope * (1.0 + kSlopeRounding) + depthRounding;
            ratio.at(state.block.left + i, state.block.top + j) =
                slope > 0.0 ? roundDown(1.0 / (safe * ratio.width))
                            : std::numeric_limits<float>::infinity();
        }
}

}  // namespace

Plane buildRelaxedCones(const DepthMap& map, ConeGuarantee guarantee, const Advance& advance,
                        SlopeSearchStatistics* statistics) {
    const bool isBilinear = guarantee == ConeGuarantee::Bilinear;
    const Plane depths = withBorder(map);
    const CrestTree tree = isBilinear ? buildCellCrestTree(depths) : buildTexelCrestTree(depths);
    tbb::enumerable_thread_specific<State> states([&] {
        return State(map, depths, tree, isBilinear ? CrestLeaves::Cells : CrestLeaves::Texels);
    });
    Plane ratio(map.width(), map.height());
    const int columns = (map.width() + kBlockSize - 1) / kBlockSize;
    const int rows = (map.height() + kBlockSize - 1) / kBlockSize;
    tbb::parallel_for(0, columns * rows, [&](int index) {
        State& state = states.local();
        const CrestBlock& block = goTo(state, map, index);
        if (isBilinear)
            findBilinearSlopes(state, map);
        else
            findTexelSlopes(state, map);
        storeRatios(state, isBilinear ? kDepthRounding : 0.0, ratio);
        if (advance)
            advance(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    });
    if (statistics != nullptr) {
        *statistics = {};
        for (const State& state : states)
            *statistics += state.work();
    }
    return ratio;
}

}  // namespace relievo::preprocess
