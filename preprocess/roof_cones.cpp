#include "preprocess/roof_cones.h"

#include <tbb/blocked_range.h>

#include <cassert>
#include <limits>
#include <utility>

#include "preprocess/apex_block.h"
#include "preprocess/block_loop.h"
#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;

// Slopes are rounded up by 1/32 at most, 1/64 in the mean; and products and quotients of floats.
constexpr int kBits = 5;
constexpr double kSlopeRounding = 1e-6;

ChordSector sectorOf(int sector, int sectors, const DepthMap& map) {
    if (sectors == 1)
        return {};
    ChordSector result;
    result.signX = sector % 2 == 0 ? 1.0f : -1.0f;
    result.signY = sector / 2 % 2 == 0 ? 1.0f : -1.0f;
    if (sectors == 8)
        result.half = sector >= 4 ? ChordSector::Half::Steep : ChordSector::Half::Shallow;
    // From the middle of one cell to a corner of another: chords between any points of the two may
    // differ by one and a half texels along each axis; and the cell before texel 0 shares an entry.
    result.slack = static_cast<float>(2.5 * (1.0 + map.texelAspect));
    return result;
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

struct RoofState {
    SlopeSearch search;
    ApexBlock apexes;
    BlockValues slopes;

    RoofState(const ReliefTree& tree, const DepthMap& map, const SlopeSearchRules& rules)
        : search(tree, map.wrap, map.texelAspect, rules) {
        apexes.known.fill(0.0f);
    }
};

Plane ratiosOf(const Plane& roof, const DepthMap& map, const ReliefTree& tree,
               const SlopeSearchRules& rules, const std::function<void(std::size_t)>& advance,
               SlopeSearchStatistics* statistics) {
    Plane ratio(map.width(), map.height());
    tbb::enumerable_thread_specific<RoofState> states([&] { return RoofState(tree, map, rules); });
    forAllBlocks(map.width(), map.height(), states, [&](RoofState& state, const BlockPlace& place) {
        state.apexes.left = static_cast<float>(place.left) + 0.5f;
        state.apexes.top = static_cast<float>(place.top) + 0.5f;
        state.apexes.width = place.width;
        state.apexes.height = place.height;
        forTexels(place,
                  [&](int i, int j, std::size_t k) { state.apexes.depth[k] = roof.at(i, j); });
        findSlopes(state.search, state.apexes, state.slopes);
        forTexels(place, [&](int i, int j, std::size_t k) {
            ratio.at(i, j) = ratioOfSlope(state.slopes[k] * (1.0 + kSlopeRounding), map.width());
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
    const double aspect = map.texelAspect;
    std::vector<RoofConeLayer> layers;
    for (int k = 0; k < rules.sectors; ++k) {
        const ChordSector sector = sectorOf(k, rules.sectors, map);
        RoofConeLayer layer;
        layer.roof =
            roofsOf(map, reachOf(sector.signX, rules.block), reachOf(sector.signY, rules.block));
        layer.ratio = ratiosOf(layer.roof, map, tree,
                               {.window = static_cast<float>(rules.block),
                                .correction = static_cast<float>((1.0 + aspect * aspect) / 4.0),
                                .halfSide = 0.5f,
                                .bits = kBits,
                                .sector = sector},
                               advance, statistics);
        layers.push_back(std::move(layer));
    }
    return layers;
}

}  // namespace relievo::preprocess
