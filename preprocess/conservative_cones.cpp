#include "preprocess/conservative_cones.h"

#include <algorithm>
#include <limits>

#include "preprocess/apex_block.h"
#include "preprocess/bilinear_cones.h"
#include "preprocess/block_loop.h"
#include "preprocess/chord_table.h"
#include "preprocess/lanes.h"
#include "preprocess/processor.h"
#include "preprocess/round_down.h"
#include "preprocess/sample_lattice.h"

#define RELIEVO_KERNEL "preprocess/steepest_chords_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using Advance = std::function<void(std::size_t)>;

// Slopes are products and quotients of a handful of floats.
constexpr double kSlopeRounding = 3e-7;

// The larger the window, the less is searched: beyond this the table takes longer.
constexpr int kTexelWindow = 12;

struct TexelState {
    SampleLattice lattice{1, kBlockSize, kTexelWindow};
    ChordTable chords;
    SlopeSearch search;
    ApexBlock apexes;
    BlockValues slopes;

    TexelState(const ReliefTree& tree, const DepthMap& map)
        : chords(lattice, {.nearest = 1, .farthest = kTexelWindow}, map.texelAspect),
          search(tree, map.wrap, map.texelAspect, {.window = kTexelWindow, .bits = 20}) {}
};

Plane texelCones(const DepthMap& map, const ReliefTree& tree, const Advance& advance,
                 SlopeSearchStatistics* statistics) {
    Plane ratio(map.width(), map.height());
    tbb::enumerable_thread_specific<TexelState> states([&] { return TexelState(tree, map); });
    forAllBlocks(map.width(), map.height(), states,
                 [&](TexelState& state, const BlockPlace& place) {
                     state.lattice.fill(map, place.left, place.top);
                     RELIEVO_CALL_KERNEL(steepestChordsOfBlock, state.chords, state.lattice,
                                         state.apexes.known);
                     state.apexes.left = static_cast<float>(place.left);
                     state.apexes.top = static_cast<float>(place.top);
                     state.apexes.width = place.width;
                     state.apexes.height = place.height;
                     forTexels(place, [&](int i, int j, std::size_t k) {
                         state.apexes.depth[k] = map.depth.at(i, j);
                     });
                     findSlopes(state.search, state.apexes, state.slopes);
                     forTexels(place, [&](int i, int j, std::size_t k) {
                         const float slope = std::max(state.slopes[k], state.apexes.known[k]);
                         ratio.at(i, j) = ratioOfSlope(slope * (1.0 + kSlopeRounding), map.width());
                     });
                     if (advance)
                         advance(place.texels());
                 });
    collect(states, statistics);
    return ratio;
}

}  // namespace

Plane buildConservativeCones(const DepthMap& map, ConeGuarantee guarantee, const Advance& advance,
                             SlopeSearchStatistics* statistics) {
    if (statistics != nullptr)
        *statistics = {};
    if (guarantee == ConeGuarantee::Bilinear)
        return BilinearCones(map, advance, statistics).ratio();
    return texelCones(map, buildReliefTree(map.depth), advance, statistics);
}

}  // namespace relievo::preprocess
