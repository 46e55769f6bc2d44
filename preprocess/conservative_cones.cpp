#include "preprocess/conservative_cones.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "preprocess/relief_tree.h"
#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;

// Above every squared ratio of floats in [0,1], and finite: times no difference of depth it is 0.
constexpr double kUnlimited = 1e200;

// Squares of texels are the unit of parallel work. Their size is fixed: the seeds, and with them
// all that is computed and counted, do not depend on the number of threads.
constexpr int kBlockSize = 64;

// A node is given up when nothing in it can be better than the limit by more than this share:
// otherwise the many ties of a perfect slope would all be visited. Three orders under what a float
// resolves, and taken off the result (kSafety), which so stays below the true ratio.
constexpr double kTie = 1e-12;
constexpr double kSafety = 1.0 - 1e-9;
// The plane test cancels terms as large as the ratio in texels: up to here its rounding error is
// under 1e-10 texels, within kSafety.
constexpr double kLargestRatioForPlanes = 1e5;

// Apexes are searched in packets of 4×4: neighbours open nearly the same nodes, and the tests of a
// node for all of them are loops that the compiler turns into vector instructions.
constexpr int kPacketSize = 4;
static_assert(kBlockSize % kPacketSize == 0);

using PerColumn = std::array<double, kPacketSize>;
using PerApex = std::array<PerColumn, kPacketSize>;  // [row][column]

struct Texel {
    int i = -1;
    int j = -1;
};

struct Node {
    int level;
    int i;
    int j;
    double bound;  // no smaller squared ratio in it, for the packet as a whole
};

// Where the nearest copies of the texels first…last of an axis lie, relative to the four columns
// (or rows) of a packet.
struct Spans {
    PerColumn low;
    PerColumn high;
    PerColumn squaredDistance;
    double leastDistance = kUnlimited;
    bool nearest = true;  // every one of the texels is nearest in the copy that is used
};

// Repeat: the nearest copy is ahead or behind. Mirror and clamp: the one inside the tile is the
// nearest, because the apex t lies in the tile. A mirrored copy y' of y lies across the tile's
// border, so the segment from t to y' meets the border at a point p, and with the part behind the
// border reflected back |t−y'| = |t−p| + |p−y'| = |t−p| + |p−y| ≥ |t−y| (and again for each further
// border). Clamp repeats the border texels outwards, farther from t than they are themselves.
template <bool kRepeat>
Spans spansFrom(const std::array<int, kPacketSize>& apexes, int first, int last, int size) {
    Spans spans;
    for (std::size_t k = 0; k < kPacketSize; ++k) {
        int low = first - apexes[k];
        int high = last - apexes[k];
        if constexpr (kRepeat) {
            int shift = 0;
            if (low > 0 && size - high < low)
                shift = -size;
            else if (high < 0 && size + low < -high)
                shift = size;
            low += shift;
            high += shift;
            spans.nearest = spans.nearest && 2 * std::max(-low, high) <= size;
        }
        const double distance = std::max({0, low, -high});
        spans.low[k] = low;
        spans.high[k] = high;
        spans.squaredDistance[k] = distance * distance;
        spans.leastDistance = std::min(spans.leastDistance, distance);
    }
    return spans;
}

double largest(const PerApex& values) {
    PerColumn ofColumn = values[0];
    for (std::size_t row = 1; row < kPacketSize; ++row)
        for (std::size_t column = 0; column < kPacketSize; ++column)
            ofColumn[column] = std::max(ofColumn[column], values[row][column]);
    return std::max(std::max(ofColumn[0], ofColumn[1]), std::max(ofColumn[2], ofColumn[3]));
}

// The search for the limiting texels of one packet of apexes after the other.
template <bool kRepeat>
class LimitSearch {
  public:
    LimitSearch(const ReliefTree& tree, const Plane& depth) : tree_(tree), depth_(depth) {}

    // Starts with the packet whose first apex is (left,top): no limits yet. At the border of the
    // map the last column and row stand in for those that it lacks.
    void begin(int left, int top) {
        greatestDepth_ = 0.0;
        for (int k = 0; k < kPacketSize; ++k) {
            columns_[static_cast<std::size_t>(k)] = std::min(left + k, tree_.width - 1);
            rows_[static_cast<std::size_t>(k)] = std::min(top + k, tree_.height - 1);
        }
        for (std::size_t row = 0; row < kPacketSize; ++row)
            for (std::size_t column = 0; column < kPacketSize; ++column) {
                apexDepth_[row][column] = depth_.at(columns_[column], rows_[row]);
                greatestDepth_ = std::max(greatestDepth_, apexDepth_[row][column]);
                squaredRatio_[row][column] = kUnlimited;
                ratio_[row][column] = kUnlimited;
                texel_[row][column] = {};
            }
    }

    void tryTexel(Texel texel) { tryTexel(texel.i, texel.j, depth_.at(texel.i, texel.j)); }

    // Searches all texels for smaller ratios than those of the texels tried.
    void search() {
        stack_.push_back({tree_.topLevel(), 0, 0, 0.0});
        while (!stack_.empty()) {
            const Node node = stack_.back();
            stack_.pop_back();
            if (node.bound >= largest(squaredRatio_) * (1.0 - kTie))
                continue;
            if (node.level == 1)
                tryChildren(node);
            else
                pushChildren(node);
        }
    }

    // In texels per unit of depth; kUnlimited or more when nothing is higher.
    [[nodiscard]] double ratio(int column, int row) const {
        return ratio_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
    [[nodiscard]] Texel limit(int column, int row) const {
        return texel_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
    [[nodiscard]] const ConeSearchStatistics& statistics() const { return statistics_; }

  private:
    // How far the texels at these spans, none less deep than `least`, are inside the cones of the
    // limits: positive where they may be, squared texels.
    [[nodiscard]] PerApex reach(const Spans& x, const Spans& y, double least) const {
        PerApex inside;
        for (std::size_t row = 0; row < kPacketSize; ++row)
            for (std::size_t column = 0; column < kPacketSize; ++column) {
                const double difference = std::max(apexDepth_[row][column] - least, 0.0);
                inside[row][column] = squaredRatio_[row][column] * (difference * difference) -
                                      (x.squaredDistance[column] + y.squaredDistance[row]);
            }
        return inside;
    }

    void tryTexel(int i, int j, double depth) {
        ++statistics_.texels;
        const Spans x = spansFrom<kRepeat>(columns_, i, i, tree_.width);
        const Spans y = spansFrom<kRepeat>(rows_, j, j, tree_.height);
        const PerApex inside = reach(x, y, depth);
        if (largest(inside) <= 0.0)
            return;
        for (std::size_t row = 0; row < kPacketSize; ++row)
            for (std::size_t column = 0; column < kPacketSize; ++column) {
                if (inside[row][column] <= 0.0)
                    continue;
                const double difference = apexDepth_[row][column] - depth;
                squaredRatio_[row][column] = (x.squaredDistance[column] + y.squaredDistance[row]) /
                                             (difference * difference);
                ratio_[row][column] = std::sqrt(squaredRatio_[row][column]);
                texel_[row][column] = {i, j};
            }
    }

    void tryChildren(const Node& node) {
        const std::array<float, 4>& depths = tree_.texels[tree_.index(1, node.i, node.j)];
        for (int k = 0; k < 4; ++k) {
            const float depth = depths[static_cast<std::size_t>(k)];
            if (depth < greatestDepth_)
                tryTexel(2 * node.i + k % 2, 2 * node.j + k / 2, depth);
        }
    }

    // The texels of node `node` of `level` along one axis, as seen from the packet.
    static Spans spansOf(const std::array<int, kPacketSize>& apexes, int level, int node,
                         int size) {
        return spansFrom<kRepeat>(apexes, node << level, std::min((node + 1) << level, size) - 1,
                                  size);
    }

    void pushChildren(const Node& parent) {
        const int level = parent.level - 1;
        const ReliefQuad& quad = tree_.quads[static_cast<std::size_t>(parent.level)]
                                            [tree_.index(parent.level, parent.i, parent.j)];
        const std::array<Spans, 2> x = {spansOf(columns_, level, 2 * parent.i, tree_.width),
                                        spansOf(columns_, level, 2 * parent.i + 1, tree_.width)};
        const std::array<Spans, 2> y = {spansOf(rows_, level, 2 * parent.j, tree_.height),
                                        spansOf(rows_, level, 2 * parent.j + 1, tree_.height)};
        const std::size_t firstPushed = stack_.size();
        for (std::size_t k = 0; k < 4; ++k) {
            const double difference = greatestDepth_ - quad.least[k];
            if (difference <= 0.0)
                continue;
            ++statistics_.nodes;
            if (!mayLimit(quad, k, x[k % 2], y[k / 2]))
                continue;
            const double acrossLeast = x[k % 2].leastDistance;
            const double downLeast = y[k / 2].leastDistance;
            insertByBound(
                {level, 2 * parent.i + static_cast<int>(k % 2),
                 2 * parent.j + static_cast<int>(k / 2),
                 (acrossLeast * acrossLeast + downLeast * downLeast) / (difference * difference)},
                firstPushed);
        }
    }

    // Keeps what was pushed since `first` sorted, the most promising on top of the stack.
    void insertByBound(const Node& node, std::size_t first) {
        std::size_t place = stack_.size();
        stack_.push_back(node);
        for (; place > first && stack_[place - 1].bound < node.bound; --place)
            stack_[place] = stack_[place - 1];
        stack_[place] = node;
    }

    // Whether some texel of child k may be inside the cone of some apex of the packet.
    [[nodiscard]] bool mayLimit(const ReliefQuad& quad, std::size_t k, const Spans& x,
                                const Spans& y) const {
        PerApex inside = reach(x, y, quad.least[k]);
        if (largest(inside) <= 0.0)
            return false;
        if (!x.nearest || !y.nearest)
            return true;
        const PerApex abovePlane = reachOfPlane(quad, k, x, y);
        for (std::size_t row = 0; row < kPacketSize; ++row)
            for (std::size_t column = 0; column < kPacketSize; ++column)
                inside[row][column] = std::min(inside[row][column], abovePlane[row][column]);
        return largest(inside) > kTie;
    }

    // The same as `reach` by the plane below child k, in texels. With y relative to the apex t, c
    // the ratio of its limit, P the plane and any unit vector w,
    //   c·(D(t) − D(y)) − |y| ≤ c·(D(t) − P(y)) − w·y,
    // which is linear in y and so greatest at a corner of the child. w points from the middle of
    // the packet to that of the child.
    [[nodiscard]] PerApex reachOfPlane(const ReliefQuad& quad, std::size_t k, const Spans& x,
                                       const Spans& y) const {
        const double middleX = x.low[1] + x.high[2];
        const double middleY = y.low[1] + y.high[2];
        const double length = std::sqrt(middleX * middleX + middleY * middleY);
        const double perLength = length > 0.0 ? 1.0 / length : 0.0;
        const double slopeX = quad.slopeX[k];
        const double slopeY = quad.slopeY[k];
        PerApex inside;
        for (std::size_t row = 0; row < kPacketSize; ++row)
            for (std::size_t column = 0; column < kPacketSize; ++column) {
                const double c = ratio_[row][column];
                const double stepX = middleX * perLength + c * slopeX;
                const double stepY = middleY * perLength + c * slopeY;
                const double planeAtApex =
                    quad.base[k] - slopeX * x.low[column] - slopeY * y.low[row];
                const double most = c * (apexDepth_[row][column] - planeAtApex) -
                                    std::min(stepX * x.low[column], stepX * x.high[column]) -
                                    std::min(stepY * y.low[row], stepY * y.high[row]);
                inside[row][column] = c < kLargestRatioForPlanes ? most : kUnlimited;
            }
        return inside;
    }

    const ReliefTree& tree_;
    const Plane& depth_;
    std::array<int, kPacketSize> columns_{};
    std::array<int, kPacketSize> rows_{};
    double greatestDepth_ = 0.0;  // of the packet
    PerApex apexDepth_{};
    PerApex squaredRatio_{};  // of the best candidates so far
    PerApex ratio_{};
    std::array<std::array<Texel, kPacketSize>, kPacketSize> texel_{};
    std::vector<Node> stack_;
    ConeSearchStatistics statistics_;
};

void storeRatio(double texelRatio, int i, int j, Plane& ratio) {
    ratio.at(i, j) = texelRatio < kUnlimited ? roundDown(texelRatio / ratio.width * kSafety)
                                             : std::numeric_limits<float>::infinity();
}

// Searches the block of texels whose first is (left,top), each packet started from the limits of
// the packets to the left and above: they are often limits again, or next to them.
template <bool kRepeat>
ConeSearchStatistics searchBlock(const ReliefTree& tree, const Plane& depth, int left, int top,
                                 Plane& ratio) {
    LimitSearch<kRepeat> search(tree, depth);
    std::array<Texel, kBlockSize> above;
    for (int j = top; j < std::min(top + kBlockSize, ratio.height); j += kPacketSize) {
        std::array<Texel, kPacketSize> before;
        for (int i = left; i < std::min(left + kBlockSize, ratio.width); i += kPacketSize) {
            Texel* const limitsAbove = &above[static_cast<std::size_t>(i - left)];
            search.begin(i, j);
            for (std::size_t k = 0; k < kPacketSize; ++k)
                for (const Texel& seed : {before[k], limitsAbove[k]})
                    if (seed.i >= 0)
                        search.tryTexel(seed);
            search.search();
            for (int k = 0; k < kPacketSize; ++k) {
                before[static_cast<std::size_t>(k)] = search.limit(kPacketSize - 1, k);
                limitsAbove[k] = search.limit(k, kPacketSize - 1);
            }
            for (int row = 0; row < std::min(kPacketSize, ratio.height - j); ++row)
                for (int column = 0; column < std::min(kPacketSize, ratio.width - i); ++column)
                    storeRatio(search.ratio(column, row), i + column, j + row, ratio);
        }
    }
    return search.statistics();
}

}  // namespace

Plane buildConservativeCones(const textures::DepthMap& map,
                             const std::function<void(std::size_t)>& advance,
                             ConeSearchStatistics* statistics) {
    const ReliefTree tree = buildReliefTree(buildDepthPyramid(map.depth));
    Plane ratio(map.width(), map.height());
    const int columns = (map.width() + kBlockSize - 1) / kBlockSize;
    const int rows = (map.height() + kBlockSize - 1) / kBlockSize;
    std::atomic<std::uint64_t> nodes{0};
    std::atomic<std::uint64_t> texels{0};
    tbb::parallel_for(0, columns * rows, [&](int block) {
        const int left = block % columns * kBlockSize;
        const int top = block / columns * kBlockSize;
        const ConeSearchStatistics work =
            map.wrap == textures::WrapMode::Repeat
                ? searchBlock<true>(tree, map.depth, left, top, ratio)
                : searchBlock<false>(tree, map.depth, left, top, ratio);
        nodes += work.nodes;
        texels += work.texels;
        if (advance)
            advance(static_cast<std::size_t>(std::min(kBlockSize, map.width() - left)) *
                    static_cast<std::size_t>(std::min(kBlockSize, map.height() - top)));
    });
    if (statistics != nullptr)
        *statistics = {nodes, texels};
    return ratio;
}

}  // namespace relievo::preprocess
