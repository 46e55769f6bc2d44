#include "preprocess/roof_cones.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "preprocess/apex_block.h"
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

// Slopes are rounded up by 1/32 at most, 1/64 in the mean; and products and quotients of floats.
constexpr int kBits = 5;
constexpr double kSlopeRounding = 1e-6;
// Samples up to so many texels from a cell are tried one by one, those beyond are searched.
constexpr int kWindow = 16;
constexpr double kHalfSide = 0.5;  // of a cell

ChordSector sectorOfCells(int number, int sectors, const DepthMap& map) {
    ChordSector sector = chordSector(number, sectors);
    // From the middle of one cell to a corner of another: chords between any points of the two may
    // differ by one and a half texels along each axis; and the cell before texel 0 shares an entry.
    sector.slack = static_cast<float>(2.5 * (1.0 + map.texelAspect));
    return sector;
}

// The samples of a cell's block along an axis: from `before` before the cell's number to `after`.
struct BlockReach {
    int before;
    int after;
};

BlockReach reachOf(float sign, int block) {
    return {sign > 0.0f ? 0 : block, sign < 0.0f ? 1 : block + 1};
}

// The least depth over the blocks of all cells: along rows, then along columns.
Plane roofsOf(const DepthMap& map, BlockReach across, BlockReach down) {
    Plane rows(map.width(), map.height());
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int i = 0; i < map.width(); ++i) {
            float least = map.at(i, j);
            for (int k = -across.before; k <= across.after; ++k)
                least = std::min(least, map.at(i + k, j));
            rows.at(i, j) = least;
        }
    });
    Plane roof(map.width(), map.height());
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int i = 0; i < map.width(); ++i)
            roof.at(i, j) = rows.at(i, j);
        for (int k = -down.before; k <= down.after; ++k) {
            const int row = textures::wrapIndex(j + k, map.height(), map.wrap);
            for (int i = 0; i < map.width(); ++i)
                roof.at(i, j) = std::min(roof.at(i, j), rows.at(i, row));
        }
    });
    return roof;
}

// The chords from cells, the middle of each half a texel after its texel's centre, to the samples
// outside its block and within the window.
ChordTable nearChords(const SampleLattice& lattice, const SlopeSearchRules& rules, int block,
                      double aspect) {
    const auto gapOf = [](double from) { return std::max(std::abs(from) - kHalfSide, 0.0); };
    return {lattice, 0, kWindow + 1,
            [=](ChordTable::Point, ChordTable::Point sample) -> std::optional<double> {
                const double fromX = sample.x - kHalfSide;
                const double fromY = sample.y - kHalfSide;
                const double across = gapOf(fromX);
                const double down = gapOf(fromY);
                const double farther = std::max(across, down);
                if (farther <= block || farther > kWindow ||
                    !rules.sector.counts(fromX, fromY * aspect, kHalfSide, kHalfSide * aspect))
                    return std::nullopt;
                return across * across + down * down * aspect * aspect - rules.correction;
            }};
}

struct RoofState {
    SampleLattice lattice{1, kBlockSize, kWindow + 1};
    ChordTable chords;
    SlopeSearch search;
    ApexBlock apexes;
    BlockValues slopes;

    RoofState(const ReliefTree& tree, const DepthMap& map, const SlopeSearchRules& rules, int block)
        : chords(nearChords(lattice, rules, block, map.texelAspect)),
          search(tree, map.wrap, map.texelAspect, rules) {}
};

Plane ratiosOf(const Plane& roof, const DepthMap& map, const ReliefTree& tree,
               const ChordSector& sector, int block,
               const std::function<void(std::size_t)>& advance, SlopeSearchStatistics* statistics) {
    const double aspect = map.texelAspect;
    const SlopeSearchRules rules{.window = static_cast<float>(std::max(kWindow, block)),
                                 .correction = static_cast<float>((1.0 + aspect * aspect) / 4.0),
                                 .halfSide = static_cast<float>(kHalfSide),
                                 .bits = kBits,
                                 .sector = sector};
    Plane ratio(map.width(), map.height());
    tbb::enumerable_thread_specific<RoofState> states(
        [&] { return RoofState(tree, map, rules, block); });
    forAllBlocks(map.width(), map.height(), states, [&](RoofState& state, const BlockPlace& place) {
        state.apexes.left = static_cast<float>(place.left) + 0.5f;
        state.apexes.top = static_cast<float>(place.top) + 0.5f;
        state.apexes.width = place.width;
        state.apexes.height = place.height;
        forTexels(place,
                  [&](int i, int j, std::size_t k) { state.apexes.depth[k] = roof.at(i, j); });
        state.lattice.fill(map, place.left, place.top);
        RELIEVO_CALL_KERNEL(steepestChordsFrom, state.apexes.depth, state.chords, state.lattice,
                            state.apexes.known);
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

std::vector<RoofConeLayer> buildRoofCones(const DepthMap& map, const RoofConeRules& rules,
                                          const std::function<void(std::size_t)>& advance,
                                          SlopeSearchStatistics* statistics) {
    assert(rules.sectors == 1 || rules.sectors == 4 || rules.sectors == 8);
    assert(rules.block >= 1);
    if (statistics != nullptr)
        *statistics = {};
    const ReliefTree tree = buildReliefTree(map.depth);
    std::vector<RoofConeLayer> layers;
    for (int k = 0; k < rules.sectors; ++k) {
        const ChordSector sector = sectorOfCells(k, rules.sectors, map);
        RoofConeLayer layer;
        layer.roof =
            roofsOf(map, reachOf(sector.signX, rules.block), reachOf(sector.signY, rules.block));
        layer.ratio = ratiosOf(layer.roof, map, tree, sector, rules.block, advance, statistics);
        layers.push_back(std::move(layer));
    }
    return layers;
}

}  // namespace relievo::preprocess
