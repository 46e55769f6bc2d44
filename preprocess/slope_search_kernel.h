// The search of slope_search.h, compiled for each generation of processors: see
// for_each_processor.h, which is why there is no include guard.

#include "preprocess/lane_operations.h"

using Node = SlopeSearchNode;

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

// All apexes of a packet, in texel widths.
struct PacketBounds {
    float left;
    float right;
    float top;
    float bottom;
};

// Which samples may be the ends of chords: those in the directions of a sector.
class SectorSamples {
  public:
    static constexpr bool kHasPlanes = true;

    SectorSamples(const ReliefTree& tree, const ChordSector& sector, float halfSide, float aspect)
        : tree_(tree), sector_(sector), halfSide_(halfSide), halfHeight_(halfSide * aspect) {}

    [[nodiscard]] int width() const { return tree_.width; }
    [[nodiscard]] int height() const { return tree_.height; }
    [[nodiscard]] int topLevel() const { return tree_.topLevel(); }
    [[nodiscard]] float leastDepth() const { return tree_.leastDepth; }
    [[nodiscard]] const ReliefQuad& quad(int level, int i, int j) const {
        return tree_.quads[static_cast<std::size_t>(level)][tree_.index(level, i, j)];
    }
    [[nodiscard]] const std::array<float, 4>& depths(int i, int j) const {
        return tree_.texels[tree_.index(1, i, j)];
    }

    // The least depth of a child of which some sample may count, for the packet as a whole.
    [[nodiscard]] float least(const ReliefQuad& quad, std::size_t child, const Span& x,
                              const Span& y, const PacketBounds& packet) const {
        return reaches(x, y, packet) ? quad.least[child] : kUnbounded;
    }

    // Whether a sample counts, by its place as seen from the apexes.
    [[nodiscard]] LaneMask counts(Lanes fromX, Lanes fromY) const {
        LaneMask inside = LaneMask{} - 1;
        const Lanes alongX = fromX * sector_.signX;
        const Lanes alongY = fromY * sector_.signY;
        // The samples at the near corners of a cell count; the next ones are a texel farther, so
        // that a quarter of one keeps rounding from leaving them out.
        if (sector_.signX != 0.0f)
            inside &= alongX >= splat(-1.5f * halfSide_);
        if (sector_.signY != 0.0f)
            inside &= alongY >= splat(-1.5f * halfHeight_);
        if (sector_.half == ChordSector::Half::Shallow)
            inside &= alongY <= alongX + sector_.slack;
        if (sector_.half == ChordSector::Half::Steep)
            inside &= alongX <= alongY + sector_.slack;
        return inside;
    }

  private:
    // The farthest that the samples of a span are ahead of the packet, against `sign`.
    static float ahead(const Span& span, float low, float high, float sign) {
        return sign > 0.0f ? span.last - low : high - span.first;
    }
    static float aheadAtLeast(const Span& span, float low, float high, float sign) {
        return sign > 0.0f ? span.first - high : low - span.last;
    }
    [[nodiscard]] bool reaches(const Span& x, const Span& y, const PacketBounds& packet) const {
        const float farX = ahead(x, packet.left, packet.right, sector_.signX);
        const float farY = ahead(y, packet.top, packet.bottom, sector_.signY);
        if ((sector_.signX != 0.0f && farX < -0.5f * halfSide_) ||
            (sector_.signY != 0.0f && farY < -0.5f * halfHeight_))
            return false;
        if (sector_.half == ChordSector::Half::Shallow)
            return aheadAtLeast(y, packet.top, packet.bottom, sector_.signY) <=
                   farX + sector_.slack;
        if (sector_.half == ChordSector::Half::Steep)
            return aheadAtLeast(x, packet.left, packet.right, sector_.signX) <=
                   farY + sector_.slack;
        return true;
    }

    const ReliefTree& tree_;
    const ChordSector sector_;
    const float halfSide_;
    const float halfHeight_;
};

// The search of one packet, among the samples that `Candidates` lets count.
template <typename Candidates>
class Traversal {
  public:
    Traversal(const Candidates& candidates, const SlopeSearchSpace& space,
              const SlopeSearchRules& rules, std::vector<Node>& stack,
              SlopeSearchStatistics& statistics)
        : candidates_(candidates),
          copies_(space.copies),
          wrap_(space.wrap),
          aspect_(space.aspect),
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
        const int i = textures::wrapIndex(place.i, candidates_.width(), wrap_);
        const int j = textures::wrapIndex(place.j, candidates_.height(), wrap_);
        const float depth =
            candidates_.depths(i / 2, j / 2)[static_cast<std::size_t>(i % 2 + 2 * (j % 2))];
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
    // The samples first…last of the tile along an axis of `size` texels, in a copy of it.
    struct Range {
        int first;
        int last;
    };
    static Range inCopy(Range range, int size, int origin, bool flips) {
        return flips ? Range{origin + size - 1 - range.last, origin + size - 1 - range.first}
                     : Range{origin + range.first, origin + range.last};
    }
    static Range rangeOf(int level, int node, int size) {
        return {node << level, std::min((node + 1) << level, size) - 1};
    }
    [[nodiscard]] Span columns(int level, int i, const TileCopy& copy) const {
        const int width = candidates_.width();
        const Range range = inCopy(rangeOf(level, i, width), width, copy.i, copy.flipsX);
        return spanOf(static_cast<float>(range.first), static_cast<float>(range.last), x_,
                      rules_.halfSide, packet_.left, packet_.right);
    }
    [[nodiscard]] Span rows(int level, int j, const TileCopy& copy) const {
        const int height = candidates_.height();
        const Range range = inCopy(rangeOf(level, j, height), height, copy.j, copy.flipsY);
        return spanOf(static_cast<float>(range.first) * aspect_,
                      static_cast<float>(range.last) * aspect_, y_, rules_.halfSide * aspect_,
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
                                          const ReliefQuad& quad, std::size_t child,
                                          const TileCopy& copy) const {
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
        const float width = x.last - x.first;
        const float height = y.last - y.first;
        // In a mirrored copy the plane begins at its other end.
        const float storedX = quad.slopeX[child];
        const float storedY = quad.slopeY[child] / aspect_;
        const float slopeX = copy.flipsX ? -storedX : storedX;
        const float slopeY = copy.flipsY ? -storedY : storedY;
        const float base = quad.base[child] + (copy.flipsX ? storedX * width : 0.0f) +
                           (copy.flipsY ? storedY * height : 0.0f);
        // From the corner of the apex that is nearest, where it is a square.
        const float toFirst =
            wx * x.first + wy * y.first - rules_.halfSide * (std::abs(wx) + std::abs(wy) * aspect_);
        const Lanes along = toFirst - (x_ * wx + y_ * wy);
        const Lanes growthX = larger(-(top_ * wx + slopeX), Lanes{}) * width;
        const Lanes growthY = larger(-(top_ * wy + slopeY), Lanes{}) * height;
        return (depth_ - base) + (growthX + growthY) > top_ * along;
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
        const int level = candidates_.topLevel();
        for (std::size_t c = 0; c < copies_.size(); ++c) {
            const Span x = columns(level, 0, copies_[c]);
            const Span y = rows(level, 0, copies_[c]);
            const float distance = x.leastGap * x.leastGap + y.leastGap * y.leastGap;
            push({level, 0, 0, static_cast<int>(c), boundOf(distance, candidates_.leastDepth())},
                 0);
        }
    }

    void pushChildren(const Node& parent) {
        const int level = parent.level - 1;
        const TileCopy& copy = copies_[static_cast<std::size_t>(parent.copy)];
        const auto& quad = candidates_.quad(parent.level, parent.i, parent.j);
        const Span xs[2] = {columns(level, 2 * parent.i, copy),
                            columns(level, 2 * parent.i + 1, copy)};
        const Span ys[2] = {rows(level, 2 * parent.j, copy), rows(level, 2 * parent.j + 1, copy)};
        const std::size_t first = stack_.size();
        for (std::size_t k = 0; k < 4; ++k) {
            const Span& x = xs[k % 2];
            const Span& y = ys[k / 2];
            if (!(quad.least[k] < greatestDepth_) || insideWindows(x, y))
                continue;
            const float least = candidates_.least(quad, k, x, y, packet_);
            if (!(least < greatestDepth_))
                continue;
            ++statistics_.nodes;
            const LaneMask rises = mayRise(x, y, least);
            if (!anyLane(rises))
                continue;
            const float distance = x.leastGap * x.leastGap + y.leastGap * y.leastGap;
            if constexpr (Candidates::kHasPlanes) {
                // A node beside the packet is on more than one side of it: its plane says little.
                const float side = static_cast<float>(1 << level);
                if (distance > side * side &&
                    !anyLane(rises & mayRiseToPlane(x, y, distance, quad, k, copy)))
                    continue;
            }
            push({level, 2 * parent.i + static_cast<int>(k % 2),
                  2 * parent.j + static_cast<int>(k / 2), parent.copy, boundOf(distance, least)},
                 first);
        }
    }

    void tryChildren(const Node& node) {
        const TileCopy& copy = copies_[static_cast<std::size_t>(node.copy)];
        const std::array<float, 4>& depths = candidates_.depths(node.i, node.j);
        changed_ = false;
        for (int k = 0; k < 4; ++k) {
            const float depth = depths[static_cast<std::size_t>(k)];
            if (!(depth < greatestDepth_))
                continue;
            const int i = 2 * node.i + k % 2;
            const int j = 2 * node.j + k / 2;
            trySample(inCopy({i, i}, candidates_.width(), copy.i, copy.flipsX).first,
                      inCopy({j, j}, candidates_.height(), copy.j, copy.flipsY).first, depth);
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
            (difference > Lanes{}) & candidates_.counts(fromX, fromY) &
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

    const Candidates& candidates_;
    const std::vector<TileCopy>& copies_;
    const textures::WrapMode wrap_;
    const float aspect_;
    const SlopeSearchRules& rules_;
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
    PacketBounds packet_{};
    float greatestDepth_ = 0.0f;
    float leastSquare_ = 0.0f;  // no sample outside the window is nearer
    float leastTopSquare_ = 0.0f;
    bool changed_ = false;
};

[[gnu::flatten]] inline void findPacketSlopes(
    const SlopeSearchSpace& space, const SlopeSearchRules& rules, const SlopePacket& packet,
    std::span<const SamplePlace> seeds, std::vector<Node>& stack, SlopeSearchStatistics& statistics,
    PacketSlopes& found) {
    const SectorSamples candidates(space.tree, rules.sector, rules.halfSide, space.aspect);
    Traversal<SectorSamples> traversal(candidates, space, rules, stack, statistics);
    traversal.begin(packet);
    for (const SamplePlace seed : seeds)
        traversal.trySample(seed);
    traversal.search();
    traversal.store(found);
}
