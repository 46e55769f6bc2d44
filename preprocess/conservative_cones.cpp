#include "preprocess/conservative_cones.h"

#include <algorithm>
#include <limits>

#include "preprocess/apex_block.h"
#include "preprocess/bilinear_slopes.h"
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

// --- Texel centres ---------------------------------------------------------------------------

constexpr int kTexelWindow = 6;

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

// --- The bilinear surface --------------------------------------------------------------------

// Samples in this window around a corner of a texel's square belong, with all cells beside them, to
// the near chords of the square.
constexpr float kCornerWindow = BilinearSlopes::kReach - 1.75f;
// κ of bilinear_slopes.h for squares of apexes and cells of samples, of one texel each.
double cornerCorrection(double aspect) {
    return 0.5 * (1.0 + aspect * aspect);
}
// Far slopes are rounded up by 1/64 at most, 1/128 in the mean.
constexpr int kFarBits = 6;
// Depths between samples are rounded to floats of a depth up to 1: so much slope may be lost over
// an eighth of a texel.
constexpr double kDepthRounding = 1.5e-6;

struct BilinearState {
    BilinearSlopes near;
    SlopeSearch search;
    ApexBlock apexes;
    BlockValues slopes;

    BilinearState(const ReliefTree& tree, const DepthMap& map)
        : near(map.texelAspect),
          search(tree, map.wrap, map.texelAspect,
                 {.window = kCornerWindow,
                  .correction = static_cast<float>(cornerCorrection(map.texelAspect)),
                  .bits = kFarBits}) {}
};

// The least slope known in the four squares around a corner.
float knownAround(const Plane& slope, const DepthMap& map, int i, int j) {
    float known = std::numeric_limits<float>::infinity();
    for (const int y : {j - 1, j})
        for (const int x : {i - 1, i})
            known = std::min(known, slope.at(textures::wrapIndex(x, map.width(), map.wrap),
                                             textures::wrapIndex(y, map.height(), map.wrap)));
    return known;
}

Plane bilinearCones(const DepthMap& map, const ReliefTree& tree, const Advance& advance,
                    SlopeSearchStatistics* statistics) {
    tbb::enumerable_thread_specific<BilinearState> states([&] { return BilinearState(tree, map); });
    Plane slope(map.width(), map.height());
    forAllBlocks(
        map.width(), map.height(), states, [&](BilinearState& state, const BlockPlace& place) {
            state.near.begin(map, place.left, place.top);
            state.near.findCoarse(state.slopes);
            forTexels(place,
                      [&](int i, int j, std::size_t k) { slope.at(i, j) = state.slopes[k]; });
        });
    Plane corner(map.width() + 1, map.height() + 1);
    forAllBlocks(
        corner.width, corner.height, states, [&](BilinearState& state, const BlockPlace& place) {
            state.near.begin(map, place.left, place.top);
            state.near.findCornerDepths(state.apexes.depth);
            state.apexes.left = static_cast<float>(place.left) - 0.5f;
            state.apexes.top = static_cast<float>(place.top) - 0.5f;
            state.apexes.width = place.width;
            state.apexes.height = place.height;
            forTexels(place, [&](int i, int j, std::size_t k) {
                state.apexes.known[k] = knownAround(slope, map, i, j);
            });
            findSlopes(state.search, state.apexes, state.slopes);
            forTexels(place,
                      [&](int i, int j, std::size_t k) { corner.at(i, j) = state.slopes[k]; });
        });
    forAllBlocks(
        map.width(), map.height(), states, [&](BilinearState& state, const BlockPlace& place) {
            state.near.begin(map, place.left, place.top);
            forTexels(place, [&](int i, int j, std::size_t k) {
                state.slopes[k] = std::max({slope.at(i, j), corner.at(i, j), corner.at(i + 1, j),
                                            corner.at(i, j + 1), corner.at(i + 1, j + 1)});
            });
            state.near.refine(state.slopes);
            forTexels(place, [&](int i, int j, std::size_t k) {
                const double known = state.slopes[k];
                const double safe =
                    known > 0.0 ? known * (1.0 + kSlopeRounding) + kDepthRounding : 0.0;
                slope.at(i, j) = ratioOfSlope(safe, map.width());
            });
            if (advance)
                advance(place.texels());
        });
    collect(states, statistics);
    return slope;
}

}  // namespace

Plane buildConservativeCones(const DepthMap& map, ConeGuarantee guarantee, const Advance& advance,
                             SlopeSearchStatistics* statistics) {
    if (statistics != nullptr)
        *statistics = {};
    const ReliefTree tree = buildReliefTree(buildDepthPyramid(map.depth));
    return guarantee == ConeGuarantee::Texel ? texelCones(map, tree, advance, statistics)
                                             : bilinearCones(map, tree, advance, statistics);
}

}  // namespace relievo::preprocess
