// The search of crest_search.h, compiled for each generation of processors: see
// for_each_processor.h, which is why there is no include guard.

#include "preprocess/square_to_cell_kernel.h"

// A bound is computed with some eight roundings of floats: a node is given up only when it stays
// under the slopes by more than these could have taken off.
constexpr float kCrestRounding = 1e-6f;

// Apexes of a quarter of a packet, in texels along reflected axes.
struct CrestQuarter {
    Lanes x;
    Lanes y;
    Lanes depth[4];
    Lanes deepest;
};

struct CrestApexes {
    CrestQuarter quarters[kQuarters];
    float left;
    float right;
    float top;
    float bottom;
    float greatestDepth;
};

// A chord that rises from each apex of a packet: the square of its slope, 0 where there is none.
using SquaredSlopes = Lanes;

// Chords between texel centres.
struct TexelLeaves {
    static constexpr float kOrigin = 0.0f;    // the first leaf, in texels
    static constexpr float kSize = 0.0f;      // of a leaf
    static constexpr float kHalfSide = 0.0f;  // of an apex
    static constexpr int kReach = -1;         // nothing is left out
    static constexpr int kBits = 20;

    const textures::Plane& depths;
    float aspect;

    [[nodiscard]] static float correction(float) { return 0.0f; }
    // Where the growth vanishes the twist of a cell decides.
    static constexpr bool kMayTwist = true;
    [[nodiscard]] float least(int i, int j) const { return depths.at(i + 1, j + 1); }
    [[nodiscard]] GradientBox gradients(int i, int j) const {
        return gradientsAtTexel(depths, i + 1, j + 1);
    }

    // The depth grows after the texel by the gradient of the cell there, which is another one on
    // each side of it; where that vanishes, by the twist of the cell.
    [[nodiscard]] SquaredSlopes steepest(const CrestQuarter& apexes, int i, int j, float x,
                                         float y) const {
        const float* const here = depths.texels.data() + depths.index(i + 1, j + 1);
        const int row = depths.width;
        const Lanes dx = x - apexes.x;
        const Lanes dy = y - apexes.y;
        const LaneMask isRight = dx > Lanes{};
        const LaneMask isBelow = dy > Lanes{};
        const Lanes alongX = isRight ? splat(here[1] - *here) : splat(here[-1] - *here);
        const Lanes alongY = isBelow ? splat(here[row] - *here) : splat(here[-row] - *here);
        const Lanes acrossBelow = isRight ? splat(here[row + 1]) : splat(here[row - 1]);
        const Lanes acrossAbove = isRight ? splat(here[1 - row]) : splat(here[-1 - row]);
        const Lanes twist = (isBelow ? acrossBelow : acrossAbove) - *here - alongX - alongY;
        const Lanes awayX = larger(dx, -dx);
        const Lanes awayY = larger(dy, -dy);
        const Lanes growth = awayX * alongX + awayY * alongY;
        const LaneMask deepens = (growth > Lanes{}) | ((growth == Lanes{}) & (twist > Lanes{}) &
                                                       (awayX * awayY > Lanes{}));
        const Lanes difference = apexes.depth[0] - *here;
        const Lanes square = dx * dx + dy * dy * (aspect * aspect);
        return deepens & (difference > Lanes{}) ? difference * difference / square : Lanes{};
    }
};

// Bounds on chords from the squares of texels to cells.
struct CellLeaves {
    static constexpr float kOrigin = -1.0f;
    static constexpr float kSize = 1.0f;
    static constexpr float kHalfSide = 0.5f;
    static constexpr int kReach = CrestSearch::kReach;
    static constexpr int kBits = 6;

    const textures::Plane& depths;
    float aspect;

    [[nodiscard]] static float correction(float aspect) { return 0.5f * (1.0f + aspect * aspect); }
    static constexpr bool kMayTwist = false;
    [[nodiscard]] GradientBox gradients(int i, int j) const {
        const float* const first = depths.texels.data() + depths.index(i, j);
        const float* const below = first + depths.width;
        return gradientsOf(first[0], first[1], below[0], below[1]);
    }
    [[nodiscard]] float least(int i, int j) const {
        const float* const first = depths.texels.data() + depths.index(i, j);
        const float* const below = first + depths.width;
        return std::min(std::min(first[0], first[1]), std::min(below[0], below[1]));
    }

    [[nodiscard]] SquaredSlopes steepest(const CrestQuarter& apexes, int i, int j, float x,
                                         float y) const {
        const float* const first = depths.texels.data() + depths.index(i, j);
        const float* const below = first + depths.width;
        const float depth[4] = {first[0], first[1], below[0], below[1]};
        const CornerSteps<Lanes> across = cornerSteps(x - apexes.x);
        const CornerSteps<Lanes> down = cornerSteps(y - apexes.y);
        const SquareToCell pair = squareToCell(apexes.depth, across, down, depth);
        const LaneMask comesOut = pair.growth > Lanes{};
        if (!anyLane(comesOut))
            return Lanes{};
        Lanes steepestChord{};
        Lanes steepestTangent{};
#pragma GCC unroll 3
        for (int b = 0; b < 3; ++b)
#pragma GCC unroll 3
            for (int a = 0; a < 3; ++a) {
                const Lanes square = across.at[a] * across.at[a] +
                                     down.at[b] * down.at[b] * (aspect * aspect) -
                                     correction(aspect);
                const Lanes perSquare = 1.0f / larger(square, splat(1.0f / kUnbounded));
                const Lanes chord = pair.chords[b][a];
                const Lanes tangent = pair.tangents[b][a];
                steepestChord = larger(steepestChord, chord * chord * perSquare);
                steepestTangent = larger(steepestTangent, tangent * tangent * perSquare);
            }
        return comesOut ? smaller(steepestChord, steepestTangent) : Lanes{};
    }
};

// The least depth of a node's leaves where a ray along a direction of the range may come out: one
// lane for each sector.
inline float leastTowards(const CrestTree::Node& node, const DirectionRange& range) {
    using Octet = float __attribute__((vector_size(32)));
    using OctetMask = std::int32_t __attribute__((vector_size(32)));
    const Octet ends = {range.dxFirst, range.dxLast, -range.dxFirst, -range.dxLast,
                        range.dyFirst, range.dyLast, -range.dyFirst, -range.dyLast};
    // How far the range goes at most in each quadrant, along x and y.
    const Octet farX = __builtin_shuffle(ends, OctetMask{1, 1, 2, 2, 1, 1, 2, 2});
    const Octet farY = __builtin_shuffle(ends, OctetMask{5, 5, 5, 5, 6, 6, 6, 6});
    // And along the axis that the sector is nearer to, beside the least along the other one.
    const Octet most = __builtin_shuffle(ends, OctetMask{1, 5, 2, 5, 1, 6, 2, 6});
    const Octet least = __builtin_shuffle(ends, OctetMask{4, 0, 4, 3, 7, 0, 7, 3});
    const OctetMask reached = (farX >= Octet{}) & (farY >= Octet{}) & (most >= least);
    Octet depths;
    std::memcpy(&depths, node.least.data(), sizeof(depths));
    depths = reached ? depths : Octet{} + std::numeric_limits<float>::infinity();
    // By halves: one after the other they would wait for each other.
    const auto lessOf = [](Octet a, Octet b) { return a < b ? a : b; };
    depths = lessOf(depths, __builtin_shuffle(depths, OctetMask{4, 5, 6, 7, 0, 1, 2, 3}));
    depths = lessOf(depths, __builtin_shuffle(depths, OctetMask{2, 3, 0, 1, 6, 7, 4, 5}));
    return std::min(depths[0], depths[1]);
}

// The same of the leaves where a ray of a sector may come out, for a range within it.
inline float leastWithin(const CrestTree::Node& node, const DirectionRange& range,
                         const ChordSector& sector) {
    const bool isLeft = sector.signX < 0.0f;
    const bool isUp = sector.signY < 0.0f;
    const float leastX = isLeft ? -range.dxLast : range.dxFirst;
    const float mostX = isLeft ? -range.dxFirst : range.dxLast;
    const float leastY = isUp ? -range.dyLast : range.dyFirst;
    const float mostY = isUp ? -range.dyFirst : range.dyLast;
    const float* const least = node.least.data() + (isLeft ? 2 : 0) + (isUp ? 4 : 0);
    const float shallow = mostX >= leastY ? least[0] : std::numeric_limits<float>::infinity();
    const float steep = mostY >= leastX ? least[1] : std::numeric_limits<float>::infinity();
    return std::min(shallow, steep);
}

// The leaves of a node along one axis, in texels, and how far they are from the packet.
struct CrestSpan {
    float first;
    float last;
    float leastGap;
};

// Steps along one axis into such a span, from the apexes of a half of the packet.
struct CrestSteps {
    Lanes squaredGaps;
    Lanes growth;   // the most that the depth may grow by them
    Lanes nearest;  // of those in the sector that is searched, in the metric
    Lanes farthest;
};

// Which apexes of a packet something counts for.
struct CrestMasks {
    LaneMask of[kQuarters];
};

// The search of one packet, in one sector of directions or in all.
template <typename Leaves, bool kInSector>
class CrestTraversal {
  public:
    using Place = CrestSearch::Place;
    using Node = CrestSearch::Node;

    CrestTraversal(const CrestSearch::Scene& scene, std::vector<Node>& stack,
                   SlopeSearchStatistics& statistics)
        : scene_(scene),
          tree_(*scene.tree),
          leaves_{*scene.depths, scene.aspect},
          correction_(Leaves::correction(scene.aspect)),
          stack_(stack),
          statistics_(statistics) {}

    void run(const CrestSearch::Packet& packet, std::span<const Place> seeds) {
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            top_[quarter] = roundedUp(loadQuarter(packet.known, quarter), Leaves::kBits);
            square_[quarter] = top_[quarter] * top_[quarter];
        }
        limitSlopes();
        const int reflections = scene_.wrap == textures::WrapMode::Mirror ? 4 : 1;
        for (int reflection = 0; reflection < reflections; ++reflection) {
            if ((reflection % 2 != 0 && scene_.copiesX == 0) ||
                (reflection / 2 != 0 && scene_.copiesY == 0))
                continue;
            reflection_ = reflection;
            sector_ = sectorSeenReflected();
            placeApexes(packet);
            for (const Place& seed : seeds)
                if (seed.reflection == reflection)
                    trySeed(seed);
            roundSlopes();
            searchCopies(-1, 1);
            searchCopies(1, farthestCopy());
        }
    }

    void store(CrestSearch::Found& found) const {
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            const auto first = static_cast<std::size_t>(quarter) * kLanes;
            storeLanes(top_[quarter], &found.slope[first]);
            std::copy_n(places_[quarter], kLanes, found.place.begin() + first);
        }
    }

  private:
    static Lanes loadQuarter(const std::array<float, kPacketApexes>& values, int quarter) {
        return loadLanes(&values[static_cast<std::size_t>(quarter) * kLanes]);
    }

    void placeApexes(const CrestSearch::Packet& packet) {
        const bool flipsX = reflection_ % 2 != 0;
        const bool flipsY = reflection_ / 2 != 0;
        const auto placeOf = [](float place, bool flips) { return flips ? -1.0f - place : place; };
        apexes_.greatestDepth = -kUnbounded;
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            CrestQuarter& some = apexes_.quarters[quarter];
            for (int lane = 0; lane < kLanes; ++lane) {
                const int column = quarter % 2 * kQuarterSize + lane % kQuarterSize;
                const int row = quarter / 2 * kQuarterSize + lane / kQuarterSize;
                some.x[lane] = placeOf(packet.column[static_cast<std::size_t>(column)], flipsX);
                some.y[lane] = placeOf(packet.row[static_cast<std::size_t>(row)], flipsY);
            }
            for (int k = 0; k < 4; ++k)
                some.depth[k] =
                    loadQuarter(packet.depth[static_cast<std::size_t>(k ^ reflection_)], quarter);
            some.deepest =
                larger(larger(some.depth[0], some.depth[1]), larger(some.depth[2], some.depth[3]));
            apexes_.greatestDepth = std::max(apexes_.greatestDepth, largestLane(some.deepest));
        }
        const auto [left, right] = std::minmax(
            {placeOf(packet.column.front(), flipsX), placeOf(packet.column.back(), flipsX)});
        const auto [top, bottom] =
            std::minmax({placeOf(packet.row.front(), flipsY), placeOf(packet.row.back(), flipsY)});
        apexes_.left = left - Leaves::kHalfSide;
        apexes_.right = right + Leaves::kHalfSide;
        apexes_.top = top - Leaves::kHalfSide;
        apexes_.bottom = bottom + Leaves::kHalfSide;
    }

    [[nodiscard]] static CrestSpan spanOf(int level, int i, int leaves, int copy, float low,
                                          float high) {
        const int end = std::min((i + 1) << level, leaves);
        const float first = Leaves::kOrigin + static_cast<float>(copy + (i << level));
        const float last = Leaves::kOrigin + static_cast<float>(copy + end - 1) + Leaves::kSize;
        return {first, last, std::max(std::max(first - high, low - last), 0.0f)};
    }
    [[nodiscard]] CrestSpan columns(int level, int i, const Place& place) const {
        return spanOf(level, i, tree_.columns, place.copyI, apexes_.left, apexes_.right);
    }
    [[nodiscard]] CrestSpan rows(int level, int j, const Place& place) const {
        return spanOf(level, j, tree_.rows, place.copyJ, apexes_.top, apexes_.bottom);
    }
    [[nodiscard]] static CrestSteps stepsTo(const CrestSpan& span, Lanes positions, float aspect,
                                            float sign, float low, float high) {
        Lanes toFirst = span.first - positions - Leaves::kHalfSide;
        Lanes toLast = span.last - positions + Leaves::kHalfSide;
        if (kInSector && sign > 0.0f)
            toFirst = larger(toFirst, Lanes{});
        else if (kInSector)
            toLast = smaller(toLast, Lanes{});
        const Lanes gaps = larger(larger(toFirst, -toLast), Lanes{}) * aspect;
        return {gaps * gaps,
                larger(larger(low * toFirst, low * toLast), larger(high * toFirst, high * toLast)),
                (sign > 0.0f ? toFirst : -toLast) * aspect,
                (sign > 0.0f ? toLast : -toFirst) * aspect};
    }
    [[nodiscard]] LaneMask isAhead(const CrestSteps& across, const CrestSteps& down) const {
        const LaneMask exists =
            (across.nearest <= across.farthest) & (down.nearest <= down.farthest);
        if (sector_.half == ChordSector::Half::Shallow)
            return exists & (down.nearest <= across.farthest * kBorderSlack);
        if (sector_.half == ChordSector::Half::Steep)
            return exists & (across.nearest <= down.farthest * kBorderSlack);
        return exists;
    }

    // Whether a chord to a leaf there, none less deep than `least`, may be steeper than the slope
    // of some apex, and the depth may grow along it by a gradient of the box.
    [[nodiscard]] CrestMasks mayCount(const CrestSpan& columns, const CrestSpan& rows, float least,
                                      const GradientBox& box) const {
        const auto& quarters = apexes_.quarters;
        const auto alongX = [&](const CrestQuarter& apexes) {
            return stepsTo(columns, apexes.x, 1.0f, sector_.signX, box.xLeast, box.xMost);
        };
        const auto alongY = [&](const CrestQuarter& apexes) {
            return stepsTo(rows, apexes.y, scene_.aspect, sector_.signY, box.yLeast, box.yMost);
        };
        const CrestSteps x[2] = {alongX(quarters[0]), alongX(quarters[1])};
        const CrestSteps y[2] = {alongY(quarters[0]), alongY(quarters[2])};
        CrestMasks masks;
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            const CrestSteps& across = x[quarter % 2];
            const CrestSteps& down = y[quarter / 2];
            const Lanes square = across.squaredGaps + down.squaredGaps - correction_;
            const Lanes difference = larger(quarters[quarter].deepest - least, Lanes{});
            const Lanes growth = across.growth + down.growth;
            masks.of[quarter] = (difference * difference > limit_[quarter] * square) &
                                (Leaves::kMayTwist ? growth >= Lanes{} : growth > Lanes{});
            if constexpr (kInSector)
                masks.of[quarter] &= isAhead(across, down);
        }
        return masks;
    }

    // The square of the steepest slope into a node, for the packet as a whole.
    [[nodiscard]] float boundOf(const CrestSpan& x, const CrestSpan& y, float least) const {
        const float down = y.leastGap * scene_.aspect;
        const float square = x.leastGap * x.leastGap + down * down - correction_;
        const float difference = apexes_.greatestDepth - least;
        if (!(difference > 0.0f))
            return 0.0f;
        return square > 0.0f ? difference * difference / square * (1.0f + kCrestRounding)
                             : kUnbounded;
    }

    [[nodiscard]] DirectionRange directions(const CrestSpan& x, const CrestSpan& y) const {
        StepRange<float> steps{{x.first - apexes_.right, y.first - apexes_.bottom},
                               {x.last - apexes_.left, y.last - apexes_.top}};
        if constexpr (kInSector)
            keepInSector(sector_, scene_.aspect, steps);
        return {steps.first[0], steps.last[0], steps.first[1], steps.last[1]};
    }
    [[nodiscard]] float leastOf(const CrestTree::Node& node, const DirectionRange& range) const {
        if constexpr (kInSector)
            return leastWithin(node, range, sector_);
        else
            return leastTowards(node, range);
    }

    [[nodiscard]] ChordSector sectorSeenReflected() const {
        ChordSector sector = scene_.sector;
        if (reflection_ % 2 != 0)
            sector.signX = -sector.signX;
        if (reflection_ / 2 != 0)
            sector.signY = -sector.signY;
        return sector;
    }

    // Sorted, the most promising on top of what was pushed since `first`.
    void push(const Node& node, std::size_t first) {
        std::size_t place = stack_.size();
        stack_.push_back(node);
        for (; place > first && stack_[place - 1].bound > node.bound; --place)
            stack_[place] = stack_[place - 1];
        stack_[place] = node;
    }

    // The first column or row of copy `copy` of the tile, along an axis that may be reflected.
    [[nodiscard]] static int copyStart(int copy, bool isReflected, int texels) {
        return isReflected ? -(copy + 1) * texels : copy * texels;
    }
    [[nodiscard]] bool isReflection(int copyX, int copyY) const {
        return scene_.wrap != textures::WrapMode::Mirror ||
               (copyX & 1) + 2 * (copyY & 1) == reflection_;
    }

    // How many copies away something steeper than what is known may be.
    [[nodiscard]] int farthestCopy() const {
        const int most = std::max(scene_.copiesX, scene_.copiesY);
        const float difference = apexes_.greatestDepth - tree_.leastDepth;
        const float side = std::min(static_cast<float>(scene_.width),
                                    static_cast<float>(scene_.height) * scene_.aspect);
        const float copies = difference / (side * std::sqrt(leastLimit_));
        return copies < static_cast<float>(most - 2) ? static_cast<int>(copies) + 2 : most;
    }

    // The copies up to `farthest` to each side, those up to `done` left out.
    void searchCopies(int done, int farthest) {
        const int copiesX = std::min(farthest, scene_.copiesX);
        const int copiesY = std::min(farthest, scene_.copiesY);
        for (int b = -copiesY; b <= copiesY; ++b)
            for (int a = -copiesX; a <= copiesX; ++a)
                if (std::max(std::abs(a), std::abs(b)) > done && isReflection(a, b))
                    pushTop({0, 0, copyStart(a, reflection_ % 2 != 0, scene_.width),
                             copyStart(b, reflection_ / 2 != 0, scene_.height), reflection_});
        search();
    }

    void pushTop(const Place& place) {
        const int level = tree_.topLevel();
        pushNode(level, place, columns(level, 0, place), rows(level, 0, place), 0);
    }

    void search() {
        while (!stack_.empty()) {
            const Node node = stack_.back();
            stack_.pop_back();
            if (node.bound <= leastLimit_)
                continue;
            if (node.level == 1)
                tryChildren(node.place);
            else
                pushChildren(node);
        }
    }

    void pushNode(int level, const Place& place, const CrestSpan& x, const CrestSpan& y,
                  std::size_t first) {
        const CrestTree::Node& node = tree_.node(level, place.i, place.j);
        const DirectionRange range = directions(x, y);
        if (kInSector && (range.dxFirst > range.dxLast || range.dyFirst > range.dyLast))
            return;
        const float growth = mostGrowth(node.gradients, range);
        if (!(Leaves::kMayTwist ? growth >= 0.0f : growth > 0.0f))
            return;
        const float least = leastOf(node, range);
        if (!(least < apexes_.greatestDepth))
            return;
        const float bound = boundOf(x, y, least);
        if (bound <= leastLimit_)
            return;
        ++statistics_.nodes;
        const CrestMasks counts = mayCount(x, y, least, node.gradients);
        if (anyLane((counts.of[0] | counts.of[1]) | (counts.of[2] | counts.of[3])))
            push({level, place, bound}, first);
    }

    // Calls visit(place, x, y) for the four parts of a node, those at `level`.
    template <typename Visit>
    void forEachPart(const Place& place, int level, int columnsThere, int rowsThere,
                     const Visit& visit) const {
        const int left = 2 * place.i;
        const int top = 2 * place.j;
        const CrestSpan x[2] = {columns(level, left, place), columns(level, left + 1, place)};
        const CrestSpan y[2] = {rows(level, top, place), rows(level, top + 1, place)};
        for (int b = 0; b < 2 && top + b < rowsThere; ++b)
            for (int a = 0; a < 2 && left + a < columnsThere; ++a)
                visit(Place{left + a, top + b, place.copyI, place.copyJ, place.reflection}, x[a],
                      y[b]);
    }

    void pushChildren(const Node& parent) {
        const int level = parent.level - 1;
        const std::size_t first = stack_.size();
        forEachPart(parent.place, level, tree_.columnsAt(level), tree_.rowsAt(level),
                    [&](const Place& place, const CrestSpan& x, const CrestSpan& y) {
                        pushNode(level, place, x, y, first);
                    });
    }

    void tryChildren(const Place& parent) {
        forEachPart(parent, 0, tree_.columns, tree_.rows,
                    [&](const Place& place, const CrestSpan& x, const CrestSpan& y) {
                        tryLeaf(place, x, y);
                    });
        roundSlopes();
    }

    void trySeed(const Place& place) {
        tryLeaf(place, columns(0, place.i, place), rows(0, place.j, place));
    }

    void tryLeaf(const Place& place, const CrestSpan& x, const CrestSpan& y) {
        const float least = leaves_.least(place.i, place.j);
        const CrestMasks counts = mayCount(x, y, least, leaves_.gradients(place.i, place.j));
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            if (!anyLane(counts.of[quarter]))
                continue;
            const LaneMask open = counts.of[quarter] & ~isLeftOut(quarter, x, y);
            if (anyLane(open))
                tryLeaf(quarter, place, open, x, y);
        }
    }

    // Cells near the apexes' squares are near_crests.h's.
    [[nodiscard]] LaneMask isLeftOut(int quarter, const CrestSpan& x, const CrestSpan& y) const {
        if constexpr (Leaves::kReach < 0)
            return LaneMask{};
        const Lanes beforeX = x.first - apexes_.quarters[quarter].x;
        const Lanes beforeY = y.first - apexes_.quarters[quarter].y;
        const auto low = static_cast<float>(-Leaves::kReach - 1);
        const auto high = static_cast<float>(Leaves::kReach);
        return (beforeX >= splat(low)) & (beforeX <= splat(high)) & (beforeY >= splat(low)) &
               (beforeY <= splat(high));
    }

    void tryLeaf(int quarter, const Place& place, LaneMask open, const CrestSpan& x,
                 const CrestSpan& y) {
        ++statistics_.samples;
        const Lanes found =
            leaves_.steepest(apexes_.quarters[quarter], place.i, place.j, x.first, y.first);
        const LaneMask steeper = open & (found > square_[quarter]);
        if (!anyLane(steeper))
            return;
        square_[quarter] = steeper ? found : square_[quarter];
        for (int k = 0; k < kLanes; ++k)
            if (steeper[k] != 0)
                places_[quarter][k] = place;
        changed_ = true;
    }

    void roundSlopes() {
        if (!changed_)
            return;
        for (int quarter = 0; quarter < kQuarters; ++quarter)
            top_[quarter] = roundedUp(squareRoots(square_[quarter]), Leaves::kBits);
        limitSlopes();
        changed_ = false;
    }

    void limitSlopes() {
        leastLimit_ = kUnbounded;
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            limit_[quarter] = top_[quarter] * top_[quarter] * (1.0f - kCrestRounding);
            leastLimit_ = std::min(leastLimit_, smallestLane(limit_[quarter]));
        }
    }

    const CrestSearch::Scene& scene_;
    const CrestTree& tree_;
    const Leaves leaves_;
    const float correction_;
    std::vector<Node>& stack_;
    SlopeSearchStatistics& statistics_;

    int reflection_ = 0;
    ChordSector sector_;  // with reflected axes
    CrestApexes apexes_{};
    Lanes square_[kQuarters]{};  // of the steepest slopes so far
    Lanes top_[kQuarters]{};     // their roots, rounded up
    Lanes limit_[kQuarters]{};   // the squares of these, less what rounding may take off a bound
    float leastLimit_ = 0.0f;
    bool changed_ = false;
    Place places_[kQuarters][kLanes];
};

template <typename Leaves>
void findCrests(const CrestSearch::Scene& scene, std::vector<CrestSearch::Node>& stack,
                SlopeSearchStatistics& statistics, const CrestSearch::Packet& packet,
                std::span<const CrestSearch::Place> seeds, CrestSearch::Found& found) {
    const auto run = [&](auto traversal) {
        traversal.run(packet, seeds);
        traversal.store(found);
    };
    if (scene.sector.isAll())
        run(CrestTraversal<Leaves, false>(scene, stack, statistics));
    else
        run(CrestTraversal<Leaves, true>(scene, stack, statistics));
}

[[gnu::flatten]] inline void findTexelCrests(const CrestSearch::Scene& scene,
                                             std::vector<CrestSearch::Node>& stack,
                                             SlopeSearchStatistics& statistics,
                                             const CrestSearch::Packet& packet,
                                             std::span<const CrestSearch::Place> seeds,
                                             CrestSearch::Found& found) {
    findCrests<TexelLeaves>(scene, stack, statistics, packet, seeds, found);
}

[[gnu::flatten]] inline void findCellCrests(const CrestSearch::Scene& scene,
                                            std::vector<CrestSearch::Node>& stack,
                                            SlopeSearchStatistics& statistics,
                                            const CrestSearch::Packet& packet,
                                            std::span<const CrestSearch::Place> seeds,
                                            CrestSearch::Found& found) {
    findCrests<CellLeaves>(scene, stack, statistics, packet, seeds, found);
}
