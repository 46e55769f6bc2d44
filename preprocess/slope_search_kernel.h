// The search of slope_search.h, compiled for each generation of processors: see
// for_each_processor.h, which is why there is no include guard.

#include "preprocess/lane_operations.h"

using Node = SlopeSearchNode;

// A bound is computed with some eight roundings of floats: a node is given up only when it stays
// under the slopes by more than these could have taken off.
constexpr float kRounding = 1e-6f;
// And one by planes with some sixteen of depths, at most 2: for a node that matters the product of
// slope and distance is no more than the depths, and that of slope and packet less still.
constexpr float kPlaneRounding = 2e-6f;
constexpr float kUnbounded = 1e30f;
// In a texel that is much higher than wide, or wider than high, the correction may be as long as a
// chord: its square then counts as this.
constexpr float kShortest = 1e-24f;

// A value for every apex of a packet.
struct Quarters {
    Lanes of[kQuarters];
};

// The samples of a node along one axis, in texel widths, as seen from the packet as a whole and
// from the apexes of each half of it: the squares of their distances.
struct Span {
    float first;
    float last;
    float leastGap;
    Lanes squaredGaps[2];
    LaneMask isAhead[2];  // whether a sample is in the directions of the sector
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

    // As ChordSector::counts: whether a sample counts, by its place as seen from the apexes.
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

    // Whether some sample of a node may be in the half of a quadrant, for the packet as a whole.
    [[nodiscard]] bool reachesHalf(const Span& x, const Span& y, const PacketBounds& packet) const {
        if (sector_.half == ChordSector::Half::Shallow)
            return aheadAtLeast(y, packet.top, packet.bottom, sector_.signY) <=
                   ahead(x, packet.left, packet.right, sector_.signX) + sector_.slack;
        if (sector_.half == ChordSector::Half::Steep)
            return aheadAtLeast(x, packet.left, packet.right, sector_.signX) <=
                   ahead(y, packet.top, packet.bottom, sector_.signY) + sector_.slack;
        return true;
    }

  private:
    // The farthest that the samples of a span are ahead of the packet, against `sign`.
    static float ahead(const Span& span, float low, float high, float sign) {
        return sign > 0.0f ? span.last - low : high - span.first;
    }
    static float aheadAtLeast(const Span& span, float low, float high, float sign) {
        return sign > 0.0f ? span.first - high : low - span.last;
    }
    const ReliefTree& tree_;
    const ChordSector sector_;
    const float halfSide_;
    const float halfHeight_;
};

// Values of the four children of a node.
inline Four fourOf(float first, float second, float third, float fourth) {
    return Four{first, second, third, fourth};
}
inline Four loadFour(const std::array<float, 4>& from) {
    Four four;
    std::memcpy(&four, from.data(), sizeof(four));
    return four;
}
inline Four largerOf(Four a, Four b) {
    return a > b ? a : b;
}

// The columns and rows of the children.
struct QuadSpans {
    Span x[2];
    Span y[2];

    template <typename Value>
    [[nodiscard]] Four alongX(const Value& value) const {
        return fourOf(value(x[0]), value(x[1]), value(x[0]), value(x[1]));
    }
    template <typename Value>
    [[nodiscard]] Four alongY(const Value& value) const {
        return fourOf(value(y[0]), value(y[0]), value(y[1]), value(y[1]));
    }
};

// What the children say to a packet as a whole.
struct QuadBounds {
    Four squaredDistance;
    Four bound;  // no chord into a child is steeper, squared
};

// Planes below the samples of the children (relief_tree.h) as bounds on chords: a chord from an
// apex at a with the slope s may rise above them where D(a) + base + s·(w·a + growth) > 0. Lane 4q
// + k is for quarter q and child k.
struct QuadPlanes {
    Lanes wx;  // towards the child
    Lanes wy;
    Lanes base;
    Lanes growth;
};

inline void setQuarter(Lanes& lanes, int quarter, float value) {
    for (int k = 0; k < 4; ++k)
        lanes[4 * quarter + k] = value;
}

// Samples of one column or row, as seen from the apexes of a half.
struct SampleLine {
    Lanes from;
    Lanes squaredGaps;
    LaneMask isOutside;  // of the window
};
struct SampleLines {
    SampleLine halves[2];
};

// The search of one packet.
class Traversal {
  public:
    Traversal(const SectorSamples& candidates, const SlopeSearchSpace& space,
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
        // Places relative to the packet, so that far from the map's first texel they round no
        // worse.
        originX_ = packet.column[0];
        originY_ = packet.row[0];
        const auto [left, right] = std::minmax_element(packet.column.begin(), packet.column.end());
        const auto [top, bottom] = std::minmax_element(packet.row.begin(), packet.row.end());
        packet_ = {*left - originX_ - rules_.halfSide, *right - originX_ + rules_.halfSide,
                   (*top - originY_ - rules_.halfSide) * aspect_,
                   (*bottom - originY_ + rules_.halfSide) * aspect_};
        greatestDepth_ = *std::max_element(packet.depth.begin(), packet.depth.end());
        for (int half = 0; half < 2; ++half)
            for (int lane = 0; lane < kLanes; ++lane) {
                const int first = half * kQuarterSize;
                x_[half][lane] =
                    placeX(packet.column[static_cast<std::size_t>(first + lane % kQuarterSize)]);
                y_[half][lane] =
                    placeY(packet.row[static_cast<std::size_t>(first + lane / kQuarterSize)]);
            }
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            const auto first = static_cast<std::size_t>(quarter) * kLanes;
            depth_.of[quarter] = loadLanes(&packet.depth[first]);
            const Lanes known = roundedDown(loadLanes(&packet.known[first]), rules_.bits);
            square_.of[quarter] = known * known;
            placeI_[quarter] = LaneMask{} + SamplePlace::kNone;
            placeJ_[quarter] = placeI_[quarter];
            const Lanes& x = x_[quarter % 2];
            const Lanes& y = y_[quarter / 2];
            setQuarter(middleX_, quarter, 0.5f * (x[0] + x[kLanes - 1]));
            setQuarter(middleY_, quarter, 0.5f * (y[0] + y[kLanes - 1]));
        }
        // What the window leaves is farther than it along one axis.
        const float nearest = rules_.window * std::min(1.0f, aspect_);
        leastSquare_ = nearest * nearest;
    }

    void trySample(SamplePlace place) {
        const int i = textures::wrapIndex(place.i, candidates_.width(), wrap_);
        const int j = textures::wrapIndex(place.j, candidates_.height(), wrap_);
        const float depth =
            candidates_.depths(i / 2, j / 2)[static_cast<std::size_t>(i % 2 + 2 * (j % 2))];
        trySample(sampleColumn(place.i), sampleRow(place.j), place.i, place.j, depth);
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
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            const auto first = static_cast<std::size_t>(quarter) * kLanes;
            storeLanes(top_.of[quarter], &found.slope[first]);
            for (int k = 0; k < kLanes; ++k)
                found.place[first + static_cast<std::size_t>(k)] = {placeI_[quarter][k],
                                                                    placeJ_[quarter][k]};
        }
    }

  private:
    [[nodiscard]] float placeX(float column) const { return column - originX_; }
    [[nodiscard]] float placeY(float row) const { return (row - originY_) * aspect_; }

    // The squares of how far it is from apexes at `positions` to samples between two places.
    static Lanes squaredGapsTo(float first, float last, Lanes positions, float halfSide) {
        const Lanes gaps = larger(larger(first - positions, positions - last) - halfSide, Lanes{});
        return gaps * gaps;
    }
    // As SectorSamples::counts.
    static LaneMask aheadOf(float first, float last, Lanes positions, float sign, float halfSide) {
        if (sign == 0.0f)
            return LaneMask{} - 1;
        return sign > 0.0f ? last - positions >= splat(-1.5f * halfSide)
                           : positions - first >= splat(-1.5f * halfSide);
    }
    static float leastGapTo(float first, float last, float low, float high) {
        return std::max(std::max(first - high, low - last), 0.0f);
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
    [[nodiscard]] Span spanOf(float first, float last, float low, float high,
                              const Lanes (&positions)[2], float halfSide, float sign) const {
        return {first,
                last,
                leastGapTo(first, last, low, high),
                {squaredGapsTo(first, last, positions[0], halfSide),
                 squaredGapsTo(first, last, positions[1], halfSide)},
                {aheadOf(first, last, positions[0], sign, halfSide),
                 aheadOf(first, last, positions[1], sign, halfSide)}};
    }
    [[nodiscard]] Span columns(int level, int i, const TileCopy& copy) const {
        const int width = candidates_.width();
        const Range range = inCopy(rangeOf(level, i, width), width, copy.i, copy.flipsX);
        return spanOf(placeX(static_cast<float>(range.first)),
                      placeX(static_cast<float>(range.last)), packet_.left, packet_.right, x_,
                      rules_.halfSide, rules_.sector.signX);
    }
    [[nodiscard]] Span rows(int level, int j, const TileCopy& copy) const {
        const int height = candidates_.height();
        const Range range = inCopy(rangeOf(level, j, height), height, copy.j, copy.flipsY);
        return spanOf(placeY(static_cast<float>(range.first)),
                      placeY(static_cast<float>(range.last)), packet_.top, packet_.bottom, y_,
                      rules_.halfSide * aspect_, rules_.sector.signY);
    }

    // Whether all samples there are in the windows of all apexes.
    [[nodiscard]] bool insideWindows(const Span& x, const Span& y) const {
        const float across = rules_.window + rules_.halfSide;
        const float down = across * aspect_;
        return x.first >= packet_.right - across && x.last <= packet_.left + across &&
               y.first >= packet_.bottom - down && y.last <= packet_.top + down;
    }

    // Whether a chord to a sample there, none less deep than `least`, may be steeper than the slope
    // of some apex of the quarter.
    [[nodiscard]] LaneMask mayRise(int quarter, const Span& x, const Span& y, float least) const {
        const int column = quarter % 2;
        const int row = quarter / 2;
        const Lanes square =
            larger(x.squaredGaps[column] + y.squaredGaps[row], splat(leastSquare_)) -
            rules_.correction;
        const Lanes difference = larger(depth_.of[quarter] - least, Lanes{});
        return (difference * difference > limit_.of[quarter] * square) & x.isAhead[column] &
               y.isAhead[row];
    }

    // Planes below the samples of children that are not beside the packet. With y relative to the
    // apex a, s its slope, P the plane and any vector w no longer than 1,
    //   (D(a) − D(y)) − s·|y| ≤ D(a) − P(y) − s·w·y,
    // which is linear in y and so greatest at a corner. The greatest of the corners is a convex
    // function of s: between the least and the greatest slope of a quarter it is under its chord.
    // w points from the middle of a quarter to that of the node.
    [[nodiscard]] QuadPlanes planesOf(const ReliefQuad& quad, const QuadSpans& spans,
                                      Four squaredDistance, const TileCopy& copy) const {
        const auto first = [](const auto& span) { return span.first; };
        const auto length = [](const auto& span) { return span.last - span.first; };
        const auto middle = [](const auto& span) { return 0.5f * (span.first + span.last); };
        const Lanes towardsX = fourTimes(spans.alongX(middle)) - middleX_;
        const Lanes towardsY = fourTimes(spans.alongY(middle)) - middleY_;
        // √(|y|² − κ) is at least |y|·√(1 − q), q = κ over the least |y|², and so |y|·(1 − q/2 −
        // q²/2).
        const Four q = rules_.correction / squaredDistance;
        const Four shortening =
            largerOf((1.0f - kRounding) * (1.0f - 0.5f * q * (1.0f + q)), Four{});
        const Lanes perLength =
            fourTimes(shortening) / squareRoots(towardsX * towardsX + towardsY * towardsY);
        QuadPlanes planes;
        planes.wx = towardsX * perLength;
        planes.wy = towardsY * perLength;
        // From the corner of the apex that is nearest, where it is a square.
        const Lanes toFirst = planes.wx * fourTimes(spans.alongX(first)) +
                              planes.wy * fourTimes(spans.alongY(first)) -
                              rules_.halfSide * (larger(planes.wx, -planes.wx) +
                                                 larger(planes.wy, -planes.wy) * aspect_);
        const Four width = spans.alongX(length);
        const Four height = spans.alongY(length);
        // In a mirrored copy the plane begins at its other end.
        const Four storedX = loadFour(quad.slopeX);
        const Four storedY = loadFour(quad.slopeY) / aspect_;
        const Lanes slopeX = fourTimes(copy.flipsX ? -storedX : storedX);
        const Lanes slopeY = fourTimes(copy.flipsY ? -storedY : storedY);
        const Lanes least = kPlaneRounding - fourTimes(loadFour(quad.base) +
                                                       (copy.flipsX ? storedX * width : Four{}) +
                                                       (copy.flipsY ? storedY * height : Four{}));
        const Lanes across = fourTimes(width);
        const Lanes down = fourTimes(height);
        const auto greatest = [&](Lanes slope) {
            return least - slope * toFirst +
                   larger(-(slope * planes.wx + slopeX), Lanes{}) * across +
                   larger(-(slope * planes.wy + slopeY), Lanes{}) * down;
        };
        const Lanes atLeast = greatest(leastTop_);
        planes.growth = (greatest(greatestTop_) - atLeast) * perTopRange_;
        planes.base = atLeast - planes.growth * leastTop_;
        return planes;
    }

    // Whether a chord to a sample of child k may be steeper than the slope of some apex of the
    // quarter, by its plane.
    [[nodiscard]] LaneMask mayRiseToPlane(int quarter, const QuadPlanes& planes, int k) const {
        const int lane = 4 * quarter + k;
        const Lanes towards = x_[quarter % 2] * planes.wx[lane] + y_[quarter / 2] * planes.wy[lane];
        return (towards + planes.growth[lane]) * top_.of[quarter] +
                   (depth_.of[quarter] + planes.base[lane]) >
               Lanes{};
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

    // Where the slopes that the packet has already leave a child out, its bound is 0.
    [[nodiscard]] QuadBounds boundsOf(const ReliefQuad& quad, const QuadSpans& spans) const {
        const auto gap = [](const auto& span) { return span.leastGap; };
        const Four across = spans.alongX(gap);
        const Four down = spans.alongY(gap);
        const Four distance = across * across + down * down;
        const Four square = largerOf(distance, Four{} + leastSquare_) - rules_.correction;
        const Four difference = largerOf(greatestDepth_ - loadFour(quad.least), Four{});
        const Four bound = square > Four{} ? difference * difference / square * (1.0f + kRounding)
                                           : Four{} + kUnbounded;
        const FourMask isOpen = (difference > Four{}) & (bound > Four{} + leastTopSquare_);
        return {distance, isOpen ? bound : Four{}};
    }

    void pushChildren(const Node& parent) {
        const int level = parent.level - 1;
        const TileCopy& copy = copies_[static_cast<std::size_t>(parent.copy)];
        const ReliefQuad& quad = candidates_.quad(parent.level, parent.i, parent.j);
        const QuadSpans spans = {
            {columns(level, 2 * parent.i, copy), columns(level, 2 * parent.i + 1, copy)},
            {rows(level, 2 * parent.j, copy), rows(level, 2 * parent.j + 1, copy)}};
        const QuadBounds bounds = boundsOf(quad, spans);
        if (bounds.bound[0] + bounds.bound[1] + bounds.bound[2] + bounds.bound[3] == 0.0f)
            return;
        const QuadPlanes planes = planesOf(quad, spans, bounds.squaredDistance, copy);
        const std::size_t first = stack_.size();
        for (int k = 0; k < 4; ++k)
            if (bounds.bound[k] > 0.0f && mayHaveSteeper(quad, spans, bounds, planes, level, k))
                push({level, 2 * parent.i + k % 2, 2 * parent.j + k / 2, parent.copy,
                      bounds.bound[k]},
                     first);
    }

    [[nodiscard]] bool mayHaveSteeper(const ReliefQuad& quad, const QuadSpans& spans,
                                      const QuadBounds& bounds, const QuadPlanes& planes, int level,
                                      int k) const {
        const Span& x = spans.x[k % 2];
        const Span& y = spans.y[k / 2];
        ++statistics_.nodes;
        // A node beside the packet is on more than one side of it: its plane says little.
        const float side = static_cast<float>(1 << level);
        const bool isBeside = bounds.squaredDistance[k] <= side * side;
        LaneMask rises[kQuarters];
        LaneMask some{};
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            rises[quarter] = isBeside ? LaneMask{} - 1 : mayRiseToPlane(quarter, planes, k);
            some |= rises[quarter];
        }
        if (!anyLane(some))
            return false;
        some = LaneMask{};
        for (int quarter = 0; quarter < kQuarters; ++quarter)
            some |=
                rises[quarter] & mayRise(quarter, x, y, quad.least[static_cast<std::size_t>(k)]);
        return anyLane(some) && !insideWindows(x, y) && candidates_.reachesHalf(x, y, packet_);
    }

    [[nodiscard]] SampleLine sampleLine(float place, Lanes positions, float halfSide,
                                        float window) const {
        const Lanes from = place - positions;
        const Lanes gaps = larger(larger(from, -from) - halfSide, Lanes{});
        return {from, gaps * gaps, gaps > splat(window)};
    }
    [[nodiscard]] SampleLines sampleColumn(int i) const {
        const float place = placeX(static_cast<float>(i));
        return {{sampleLine(place, x_[0], rules_.halfSide, rules_.window),
                 sampleLine(place, x_[1], rules_.halfSide, rules_.window)}};
    }
    [[nodiscard]] SampleLines sampleRow(int j) const {
        const float place = placeY(static_cast<float>(j));
        const float halfHeight = rules_.halfSide * aspect_;
        const float window = rules_.window * aspect_;
        return {{sampleLine(place, y_[0], halfHeight, window),
                 sampleLine(place, y_[1], halfHeight, window)}};
    }

    void tryChildren(const Node& node) {
        const TileCopy& copy = copies_[static_cast<std::size_t>(node.copy)];
        const std::array<float, 4>& depths = candidates_.depths(node.i, node.j);
        const auto placed = [](int texel, int size, int origin, bool flips) {
            return inCopy({texel, texel}, size, origin, flips).first;
        };
        int i[2];
        int j[2];
        for (int k = 0; k < 2; ++k) {
            i[k] = placed(2 * node.i + k, candidates_.width(), copy.i, copy.flipsX);
            j[k] = placed(2 * node.j + k, candidates_.height(), copy.j, copy.flipsY);
        }
        const SampleLines x[2] = {sampleColumn(i[0]), sampleColumn(i[1])};
        const SampleLines y[2] = {sampleRow(j[0]), sampleRow(j[1])};
        changed_ = false;
        for (int k = 0; k < 4; ++k)
            trySample(x[k % 2], y[k / 2], i[k % 2], j[k / 2], depths[static_cast<std::size_t>(k)]);
        if (changed_)
            roundSlopes();
    }

    void trySample(const SampleLines& x, const SampleLines& y, int i, int j, float depth) {
        if (!(depth < greatestDepth_))
            return;
        ++statistics_.samples;
        for (int quarter = 0; quarter < kQuarters; ++quarter)
            trySample(quarter, x.halves[quarter % 2], y.halves[quarter / 2], i, j, depth);
    }

    void trySample(int quarter, const SampleLine& x, const SampleLine& y, int i, int j,
                   float depth) {
        const Lanes square =
            larger(x.squaredGaps + y.squaredGaps - rules_.correction, splat(kShortest));
        const Lanes difference = depth_.of[quarter] - depth;
        Lanes& steepest = square_.of[quarter];
        LaneMask steeper = (difference > Lanes{}) & (x.isOutside | y.isOutside) &
                           (difference * difference > steepest * square);
        if (!anyLane(steeper))
            return;
        steeper &= candidates_.counts(x.from, y.from);
        if (!anyLane(steeper))
            return;
        changed_ = true;
        steepest = steeper ? difference * difference / square : steepest;
        placeI_[quarter] = steeper ? LaneMask{} + i : placeI_[quarter];
        placeJ_[quarter] = steeper ? LaneMask{} + j : placeJ_[quarter];
    }

    void roundSlopes() {
        leastTopSquare_ = kUnbounded;
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            top_.of[quarter] = roundedUp(squareRoots(square_.of[quarter]), rules_.bits);
            limit_.of[quarter] = top_.of[quarter] * top_.of[quarter] * (1.0f - kRounding);
            leastTopSquare_ = std::min(leastTopSquare_, smallestLane(limit_.of[quarter]));
            setQuarter(leastTop_, quarter, smallestLane(top_.of[quarter]));
            setQuarter(greatestTop_, quarter, largestLane(top_.of[quarter]));
        }
        const Lanes range = greatestTop_ - leastTop_;
        perTopRange_ = range > Lanes{} ? 1.0f / range : Lanes{};
    }

    const SectorSamples& candidates_;
    const std::vector<TileCopy>& copies_;
    const textures::WrapMode wrap_;
    const float aspect_;
    const SlopeSearchRules& rules_;
    std::vector<Node>& stack_;
    SlopeSearchStatistics& statistics_;

    Lanes x_[2]{};  // of each half
    Lanes y_[2]{};
    // Of quarters, as in QuadPlanes.
    Lanes middleX_{};
    Lanes middleY_{};
    Lanes leastTop_{};
    Lanes greatestTop_{};
    Lanes perTopRange_{};
    Quarters depth_{};
    Quarters square_{};  // of the steepest slopes so far
    Quarters top_{};     // their roots, rounded up
    Quarters limit_{};   // the squares of these, less what rounding may take off a bound
    LaneMask placeI_[kQuarters]{};
    LaneMask placeJ_[kQuarters]{};
    PacketBounds packet_{};
    float originX_ = 0.0f;  // of all places, in texels
    float originY_ = 0.0f;
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
    Traversal traversal(candidates, space, rules, stack, statistics);
    traversal.begin(packet);
    for (const SamplePlace seed : seeds)
        traversal.trySample(seed);
    traversal.search();
    traversal.store(found);
}
