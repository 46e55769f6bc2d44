#include "preprocess/relaxed_cones.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

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

    State(const DepthMap& map, const Plane& depths, const CrestTree& tree, CrestLeaves leaves,
          const ChordSector& sector)
        : search(map, depths, tree, leaves, sector), near(map.texelAspect, sector) {}

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

// A relief prepared for the search of its crests.
struct Crests {
    const DepthMap& map;
    bool isBilinear;
    Plane depths;
    CrestTree tree;

    Crests(const DepthMap& relief, ConeGuarantee guarantee)
        : map(relief),
          isBilinear(guarantee == ConeGuarantee::Bilinear),
          depths(withBorder(relief)),
          tree(isBilinear ? buildCellCrestTree(depths) : buildTexelCrestTree(depths)) {}
};

// Where a chord to a point far outside is taken for one to the border beside it, which has another
// direction (crest_search.h), quadrants are not divided.
ChordSector sectorOn(const DepthMap& map, int number, int sectors) {
    ChordSector sector = chordSector(number, sectors);
    if (map.wrap == textures::WrapMode::Clamp || map.width() == 1 || map.height() == 1)
        sector.half = ChordSector::Half::Both;
    return sector;
}

Plane ratiosOf(const Crests& crests, const ChordSector& sector, const Advance& advance,
               SlopeSearchStatistics* statistics) {
    const DepthMap& map = crests.map;
    tbb::enumerable_thread_specific<State> states([&] {
        return State(map, crests.depths, crests.tree,
                     crests.isBilinear ? CrestLeaves::Cells : CrestLeaves::Texels, sector);
    });
    Plane ratio(map.width(), map.height());
    const int columns = (map.width() + kBlockSize - 1) / kBlockSize;
    const int rows = (map.height() + kBlockSize - 1) / kBlockSize;
    tbb::parallel_for(0, columns * rows, [&](int index) {
        State& state = states.local();
        const CrestBlock& block = goTo(state, map, index);
        if (crests.isBilinear)
            findBilinearSlopes(state, map);
        else
            findTexelSlopes(state, map);
        storeRatios(state, crests.isBilinear ? kDepthRounding : 0.0, ratio);
        if (advance)
            advance(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    });
    if (statistics != nullptr)
        for (const State& state : states)
            *statistics += state.work();
    return ratio;
}

}  // namespace

Plane buildRelaxedCones(const DepthMap& map, ConeGuarantee guarantee, const Advance& advance,
                        SlopeSearchStatistics* statistics) {
    return std::move(buildRelaxedConeSectors(map, guarantee, 1, advance, statistics).front());
}

std::vector<Plane> buildRelaxedConeSectors(const DepthMap& map, ConeGuarantee guarantee,
                                           int sectors, const Advance& advance,
                                           SlopeSearchStatistics* statistics) {
    assert(sectors == 1 || sectors == 4 || sectors == 8);
    if (statistics != nullptr)
        *statistics = {};
    const Crests crests(map, guarantee);
    std::vector<Plane> ratios;
    for (int k = 0; k < sectors; ++k) {
        const ChordSector sector = sectorOn(map, k, sectors);
        const bool isBuilt = k >= 4 && sector.half == ChordSector::Half::Both;
        ratios.push_back(isBuilt ? Plane(ratios[static_cast<std::size_t>(k - 4)])
                                 : ratiosOf(crests, sector, advance, statistics));
        if (isBuilt && advance)
            advance(map.depth.texels.size());
    }
    return ratios;
}

}  // namespace relievo::preprocess
