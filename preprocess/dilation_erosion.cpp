#include "preprocess/dilation_erosion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

namespace relievo::preprocess {
namespace {

using textures::Plane;

// Columns that are worked on side by side: a cache line of rows, and vector instructions.
constexpr int kStripe = 64;

// Lines of texels side by side, and what the extrema of windows along them are made of.
template <std::size_t kLines>
class WindowScan {
  public:
    using Texels = std::array<float, kLines>;

    explicit WindowScan(int length)
        : line_(static_cast<std::size_t>(length)), ahead_(line_.size()), behind_(line_.size()) {}

    // Place k of the lines.
    Texels& operator[](int k) { return line_[static_cast<std::size_t>(k)]; }

    // Calls use(i, extrema over the places i … i+window−1) for every window that the lines hold.
    //
    // The lines are cut into blocks as long as a window, which then covers the end of one block and
    // the beginning of the next: one running extremum from each side of every block answers all.
    template <typename Pick, typename Use>
    void scan(int window, const Pick& pick, const Use& use) {
        const auto length = static_cast<int>(line_.size());
        for (int k = 0; k < length; ++k)
            join(ahead_, k, k - 1, k % window != 0, pick);
        for (int k = length - 1; k >= 0; --k)
            join(behind_, k, k + 1, (k + 1) % window != 0 && k + 1 < length, pick);
        for (int i = 0; i + window <= length; ++i) {
            Texels extrema = behind_[static_cast<std::size_t>(i)];
            combine(extrema, ahead_[static_cast<std::size_t>(i + window - 1)], pick);
            use(i, extrema);
        }
    }

  private:
    template <typename Pick>
    static void combine(Texels& texels, const Texels& other, const Pick& pick) {
        for (std::size_t k = 0; k < kLines; ++k)
            texels[k] = pick(texels[k], other[k]);
    }

    // The running extremum at place k, from that at `before` when both are of one block.
    template <typename Pick>
    void join(std::vector<Texels>& running, int k, int before, bool sameBlock, const Pick& pick) {
        Texels& here = running[static_cast<std::size_t>(k)];
        here = line_[static_cast<std::size_t>(k)];
        if (sameBlock)
            combine(here, running[static_cast<std::size_t>(before)], pick);
    }

    std::vector<Texels> line_;
    std::vector<Texels> ahead_;
    std::vector<Texels> behind_;
};

template <typename Pick>
Plane pickAlongRows(const textures::DepthMap& map, int reach, const Pick& pick) {
    Plane picked(map.width(), map.height());
    tbb::parallel_for(0, map.height(), [&](int j) {
        WindowScan<1> row(map.width() + 2 * reach);
        for (int k = 0; k < map.width() + 2 * reach; ++k)
            row[k][0] = map.at(k - reach, j);
        row.scan(2 * reach + 1, pick,
                 [&](int i, const auto& extrema) { picked.at(i, j) = extrema[0]; });
    });
    return picked;
}

template <typename Pick>
void pickAlongColumns(Plane& plane, textures::WrapMode wrap, int reach, const Pick& pick) {
    tbb::parallel_for(0, (plane.width + kStripe - 1) / kStripe, [&](int stripe) {
        const int first = stripe * kStripe;
        const auto count = static_cast<std::size_t>(std::min(kStripe, plane.width - first));
        WindowScan<kStripe> columns(plane.height + 2 * reach);
        for (int k = 0; k < plane.height + 2 * reach; ++k)
            std::copy_n(&plane.at(first, wrapIndex(k - reach, plane.height, wrap)), count,
                        columns[k].begin());
        columns.scan(2 * reach + 1, pick, [&](int j, const auto& extrema) {
            std::copy_n(extrema.begin(), count, &plane.at(first, j));
        });
    });
}

template <typename Pick>
Plane pickAround(const textures::DepthMap& map, int reach, const Pick& pick) {
    Plane plane = pickAlongRows(map, reach, pick);
    pickAlongColumns(plane, map.wrap, reach, pick);
    return plane;
}

}  // namespace

DepthExtrema findDepthExtrema(const textures::DepthMap& map, int reach) {
    assert(reach >= 0);
    return {pickAround(map, reach, [](float a, float b) { return std::min(a, b); }),
            pickAround(map, reach, [](float a, float b) { return std::max(a, b); })};
}

}  // namespace relievo::preprocess
