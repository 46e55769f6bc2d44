// The search of slope_search.h, compiled for each generation of processors: see
// for_each_processor.h, which is why there is no include guard.

#include "preprocess/lane_operations.h"

using Node = SlopeSearch::Node;

// A bound is computed with some eight roundings of floats: a node is given up only when it stays
// under the slopes by more than these could have taken off.
constexpr float kRounding = 1e-6f;
constexpr float kUnbounded = 1e30f;

// The samples of a node along one axis, in texel widths: seen from all apexes, and from the packet
// as a whole.
struct Span {
    float first;
    float last;
    Lanes squaredGaps;
    float leastGap;
};

// The search of one packet.
class Traversal {
  public:
    Traversal(const ReliefTree& tree, bool repeats, float aspect, const SlopeSearchRules& rules,
              std::vector<Node>& stack, SlopeSearchStatistics& statistics)
        : tree_(tree),
          repeats_(repeats),
          aspect_(aspect),
          rules_(rules),
          stack_(stack),
          statistics_(statistics) {}

    void begin(const SlopePacket& packet) {
        x_ = loadLanes(packet.column.data());
        y_ = loadLanes(packet.row.data()) * aspect_;
        depth_ = loadLanes(packet.depth.data());
        greatestDepth_ = largestLane(depth_);
        packet_ = {smallestLane(x_) - rules_.halfSide, largestLane(x_) + rules_.halfSide,
                   smallestLane(y_) - rules_.halfSide * aspect_,
                   largestLane(y_) + rules_.halfSide * aspect_};
        known_ = roundedDown(loadLanes(packet.known.data()), rules_.bits);
        square_ = known_ * known_;
        placeI_ = LaneMask{} + SamplePlace::kNone;
        placeJ_ = placeI_;
        // What the window leaves is farther than it along one axis.
        const float nearest = rules_.window * std::min(1.0f, aspect_);
        leastSquare_ = nearest * nearest;
    }

    void trySample(SamplePlace place) {
        const int i = textures::wrapIndex(place.i, tree_.width, textures::WrapMode::Repeat);
        const int j = textures::wrapIndex(place.j, tree_.height, textures::WrapMode::Repeat);
        const float depth = tree_.texels[tree_.index(1, i / 2, j / 2)]
                                        [static_cast<std::size_t>(i % 2 + 2 * (j % 2))];
        trySample(place.i, place.j, depth);
    }

    void search() {
        roundSlopes();
        pushRoots();
        while (!stack_.empty()) {
            const Node node = stack_.back();
            stack_.pop_back();
            if (node.bound <= leastTopSquare_)
                continue;
            if (node.level == 1)
                tryChildren(node);
            else
                pushChildren(node);
        }
    }

    void store(PacketSlopes& found) const {
        storeLanes(top_, found.slope.data());
        for (int k = 0; k < kLanes; ++k)
            found.place[static_cast<std::size_t>(k)] = {placeI_[k], placeJ_[k]};
    }

  private:
    // The samples from `first` to `last` along an axis: `positions` are those of the apexes, `low`
    // and `high` those of the packet.
    [[nodiscard]] static Span spanOf(float first, float last, Lanes positions, float halfSide,
                                     float low, float high) {
        const Lanes gaps = larger(larger(first - positions, positions - last) - halfSide, Lanes{});
        return {first, last, gaps * gaps, std::max(std::max(first - high, low - last), 0.0f)};
    }
    [[nodiscard]] Span columns(int level, int i, int copy) const {
        const int last = std::min((i + 1) << level, tree_.width) - 1;
        return spanOf(static_cast<float>(copy + (i << level)), static_cast<float>(copy + last), x_,
                      rules_.halfSide, packet_.left, packet_.right);
    }
    [[nodiscard]] Span rows(int level, int j, int copy) const {
        const int last = std::min((j + 1) << level, tree_.height) - 1;
        return spanOf(static_cast<float>(copy + (j << level)) * aspect_,
                      static_cast<float>(copy + last) * aspect_, y_, rules_.halfSide * aspect_,
                      packet_.top, packet_.bottom);
    }

    // Whether all samples there are in the windows of all apexes.
    [[nodiscard]] bool insideWindows(const Span& x, const Span& y) const {
        const float across = rules_.window + rules_.halfSide;
        const float down = across * aspect_;
        return x.first >= packet_.right - across && x.last <= packet_.left + across &&
               y.first >= packet_.bottom - down && y.last <= packet_.top + down;
    }

    // Whether a chord to a sample there, none less deep than `least`, may be steeper than the slope
    // of some apex.
    [[nodiscard]] LaneMask mayRise(const Span& x, const Span& y, float least) const {
        const Lanes square =
            larger(x.squaredGaps + y.squaredGaps, splat(leastSquare_)) - rules_.correction;
        const Lanes difference = larger(depth_ - least, Lanes{});
        return difference * difference > limit_ * square;
    }

    // The same by the plane below the samples there. With y relative to the apex a, s its slope, P
    // the plane and any vector w no longer than 1,
    //   (D(a) − D(y)) − s·|y| ≤ D(a) − P(y) − s·w·y,
    // which is linear in y and so greatest at a corner. w points from the middle of the packet to
    // that of the node.
    [[nodiscard]] LaneMask mayRiseToPlane(const Span& x, const Span& y, float squaredDistance,
                                          const ReliefQuad& quad, std::size_t child) const {
        const float towardsX = x.first + x.last - packet_.left - packet_.right;
        const float towardsY = y.first + y.last - packet_.top - packet_.bottom;
        const float perLength =
            (1.0f - kRounding) / std::sqrt(towardsX * towardsX + towardsY * towardsY);
        // √(|y|² − κ) is at least |y|·√(1 − q), q = κ over the least |y|², and so |y|·(1 − q/2 −
        // q²/2).
        const float q = rules_.correction / squaredDistance;
        const float shortening = 1.0f - 0.5f * q * (1.0f + q);
        const float wx = towardsX * perLength * shortening;
        const float wy = towardsY * perLength * shortening;
        const float slopeX = quad.slopeX[child];
        const float slopeY = quad.slopeY[child] / aspect_;
        const float width = x.last - x.first;
        const float height = y.last - y.first;
        // From the corner of the apex that is nearest, where it is a square.
        const float toFirst =
            wx * x.first + wy * y.first - rules_.halfSide * (std::abs(wx) + std::abs(wy) * aspect_);
        const Lanes along = toFirst - (x_ * wx + y_ * wy);
        const Lanes growthX = larger(-(top_ * wx + slopeX), Lanes{}) * width;
        const Lanes growthY = larger(-(top_ * wy + slopeY), Lanes{}) * height;
        return (depth_ - quad.base[child]) + (growthX + growthY) > top_ * along;
    }

    // The square of the steepest slope into a node, for the packet as a whole.
    [[nodiscard]] float boundOf(float squaredDistance, float least) const {
        const float square = std::max(squaredDistance, leastSquare_) - rules_.correction;
        const float difference = greatestDepth_ - least;
        return square > 0.0f ? difference * difference / square * (1.0f + kRounding) : kUnbounded;
    }

    // Sorted, the most promising on top of what was pushed since `first`.
    void push(const Node& node, std::size_t first) {
        std::size_t place = stack_.size();
        stack_.push_back(node);
        for (; place > first && stack_[place - 1].bound > node.bound; --place)
            stack_[place] = stack_[place - 1];
        stack_[place] = node;
    }

    void pushRoots() {
        const int copies = repeats_ ? 1 : 0;
        const int level = tree_.topLevel();
        for (int b = -copies; b <= copies; ++b)
            for (int a = -copies; a <= copies; ++a) {
                const Span x = columns(level, 0, a * tree_.width);
                const Span y = rows(level, 0, b * tree_.height);
                const float distance = x.leastGap * x.leastGap + y.leastGap * y.leastGap;
                push({level, 0, 0, a * tree_.width, b * tree_.height,
                      boundOf(distance, tree_.leastDepth)},
                     0);
            }
    }

    void pushChildren(const Node& parent) {
        const int level = parent.level - 1;
        const ReliefQuad& quad = tree_.quads[static_cast<std::size_t>(parent.level)]
                                            [tree_.index(parent.level, parent.i, parent.j)];
        const Span xs[2] = {columns(level, 2 * parent.i, parent.copyI),
                            columns(level, 2 * parent.i + 1, parent.copyI)};
        const Span ys[2] = {rows(level, 2 * parent.j, parent.copyJ),
                            rows(level, 2 * parent.j + 1, parent.copyJ)};
        const std::size_t first = stack_.size();
        for (std::size_t k = 0; k < 4; ++k) {
            const Span& x = xs[k % 2];
            const Span& y = ys[k / 2];
            const float least = quad.least[k];
            if (!(least < greatestDepth_) || insideWindows(x, y))
                continue;
            ++statistics_.nodes;
            const LaneMask rises = mayRise(x, y, least);
            if (!anyLane(rises))
                continue;
            // A node beside the packet is on more than one side of it: its plane says little.
            const float distance = x.leastGap * x.leastGap + y.leastGap * y.leastGap;
            const float side = static_cast<float>(1 << level);
            if (distance > side * side && !anyLane(rises & mayRiseToPlane(x, y, distance, quad, k)))
                continue;
            push({level, 2 * parent.i + static_cast<int>(k % 2),
                  2 * parent.j + static_cast<int>(k / 2), parent.copyI, parent.copyJ,
                  boundOf(distance, least)},
                 first);
        }
    }

    void tryChildren(const Node& node) {
        const std::array<float, 4>& depths = tree_.texels[tree_.index(1, node.i, node.j)];
        changed_ = false;
        for (int k = 0; k < 4; ++k) {
            const float depth = depths[static_cast<std::size_t>(k)];
            if (depth < greatestDepth_)
                trySample(node.copyI + 2 * node.i + k % 2, node.copyJ + 2 * node.j + k / 2, depth);
        }
        if (changed_)
            roundSlopes();
    }

    void trySample(int i, int j, float depth) {
        ++statistics_.samples;
        const Lanes fromX = static_cast<float>(i) - x_;
        const Lanes fromY = static_cast<float>(j) * aspect_ - y_;
        const Lanes across = larger(larger(fromX, -fromX) - rules_.halfSide, Lanes{});
        const Lanes down = larger(larger(fromY, -fromY) - rules_.halfSide * aspect_, Lanes{});
        const Lanes square = across * across + down * down - rules_.correction;
        const Lanes difference = depth_ - depth;
        const LaneMask steeper =
            (difference > Lanes{}) &
            ((across > splat(rules_.window)) | (down > splat(rules_.window * aspect_))) &
            (difference * difference > square_ * square);
        if (!anyLane(steeper))
            return;
        changed_ = true;
        square_ = steeper ? difference * difference / square : square_;
        placeI_ = steeper ? LaneMask{} + i : placeI_;
        placeJ_ = steeper ? LaneMask{} + j : placeJ_;
    }

    void roundSlopes() {
        top_ = roundedUp(squareRoots(square_), rules_.bits);
        const Lanes topSquare = top_ * top_;
        limit_ = topSquare * (1.0f - kRounding);
        leastTopSquare_ = smallestLane(limit_);
    }

    const ReliefTree& tree_;
    const bool repeats_;
    const float aspect_;
    const SlopeSearchRules rules_;
    std::vector<Node>& stack_;
    SlopeSearchStatistics& statistics_;

    Lanes x_{};
    Lanes y_{};
    Lanes depth_{};
    Lanes known_{};
    Lanes square_{};  // of the steepest slopes so far
    Lanes top_{};     // their roots, rounded up
    Lanes limit_{};   // the squares of these, less what rounding may take off a bound
    LaneMask placeI_{};
    LaneMask placeJ_{};
    struct {
        float left;
        float right;
        float top;
        float bottom;
    } packet_{};  // all apexes, in texel widths
    float greatestDepth_ = 0.0f;
    float leastSquare_ = 0.0f;  // no sample outside the window is nearer
    float leastTopSquare_ = 0.0f;
    bool changed_ = false;
};

[[gnu::flatten]] inline void findPacketSlopes(Traversal traversal, const SlopePacket& packet,
                                              std::span<const SamplePlace> seeds,
                                              PacketSlopes& found) {
    traversal.begin(packet);
    for (const SamplePlace seed : seeds)
        traversal.trySample(seed);
    traversal.search();
    traversal.store(found);
}
