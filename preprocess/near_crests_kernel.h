// The search of near_crests.h, compiled for each generation of processors: see
// for_each_processor.h, which is why there is no include guard.

#include "preprocess/crest_pairs_kernel.h"

using OpenPairs = NearCrests::OpenPairs;
constexpr int kParts = NearCrests::kParts;

[[gnu::flatten]] inline void findSquareDepths(const Surroundings& surface,
                                              std::array<BlockValues, 4>& depth) {
    for (int j = 0; j < kBlockSize; ++j)
        for (int i = 0; i < kBlockSize; i += kLanes) {
            const Squares squares = squaresAt(surface, i, j);
            for (std::size_t k = 0; k < 4; ++k)
                storeLanes(squares.patch[k], &depth[k][blockIndex(i, j)]);
        }
}

// Cells from −kBeside−1 to kBeside beside a texel are too near to its square for chords between
// corners: the square's four quarters are looked at one by one.
constexpr int kBeside = 1;
inline bool isBeside(int x, int y) {
    return x >= -kBeside - 1 && x <= kBeside && y >= -kBeside - 1 && y <= kBeside;
}

// Cells along an axis that chords from the square of texel 0 in directions of a sign lead through,
// of those from `first` to `last`.
struct CellSpan {
    int first;
    int last;
};
inline CellSpan cellsAhead(float sign, int first, int last) {
    return {sign > 0.0f ? -1 : first, sign < 0.0f ? 0 : last};
}

// Leaves what is in the sector; false without any.
inline bool keepInSector(const Squares& squares, StepRange<float>& steps) {
    if (squares.sector.isAll())
        return true;
    keepInSector(squares.sector, squares.aspect, steps);
    return steps.first[0] <= steps.last[0] && steps.first[1] <= steps.last[1];
}
inline bool isInSector(const Squares& squares, float x, float y) {
    StepRange<float> step{{x, y}, {x, y}};
    return keepInSector(squares, step);
}

// Calls visit(x, y) for the cells around a texel where chords of the sector may end.
template <typename Visit>
void forEachCell(const Squares& squares, const Visit& visit) {
    for (int y = -kReach - 1; y <= kReach; ++y)
        for (int x = -kReach - 1; x <= kReach; ++x) {
            const auto left = static_cast<float>(x);
            const auto top = static_cast<float>(y);
            StepRange<float> steps{{left - 0.5f, top - 0.5f}, {left + 1.5f, top + 1.5f}};
            if (keepInSector(squares, steps))
                visit(x, y);
        }
}

// One over a squared length, from which a correction was taken.
inline float reciprocal(float square) {
    return square > 1e-6f ? 1.0f / square : kUnbounded;
}

// The same of the steps between corners, less `correction`.
inline void reciprocals(const CornerSteps<float>& across, const CornerSteps<float>& down,
                        float aspect, float correction, float perSquare[3][3]) {
    for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a) {
            const float height = down.at[b] * aspect;
            perSquare[b][a] =
                reciprocal(across.at[a] * across.at[a] + height * height - correction);
        }
}

// The squares of the slopes of the steepest chords from corners of squares to corners of cells
// along which rays come out.
inline Lanes attainedBetween(const Squares& squares, const CellLanes& cell, int x, int y) {
    const CornerSteps<float> across = cornerSteps(static_cast<float>(x));
    const CornerSteps<float> down = cornerSteps(static_cast<float>(y));
    float perSquare[3][3];
    reciprocals(across, down, squares.aspect, 0.0f, perSquare);
    for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
            if (!isInSector(squares, across.at[a], down.at[b]))
                perSquare[b][a] = 0.0f;
    const Lanes growthX[2] = {cell.depth[1] - cell.depth[0], cell.depth[3] - cell.depth[2]};
    const Lanes growthY[2] = {cell.depth[2] - cell.depth[0], cell.depth[3] - cell.depth[1]};
    Lanes steepest{};
#pragma GCC unroll 4
    for (int l = 0; l < 4; ++l)
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            const int a = 1 + l % 2 - k % 2;
            const int b = 1 + l / 2 - k / 2;
            const Lanes grows = across.at[a] * growthX[l / 2] + down.at[b] * growthY[l % 2];
            const Lanes rises =
                larger(squares.depths.at[k / 2 * 2][k % 2 * 2] - cell.depth[l], Lanes{});
            const Lanes slope = rises * rises * perSquare[b][a];
            steepest = larger(steepest, grows > Lanes{} ? slope : Lanes{});
        }
    return steepest;
}

[[gnu::flatten]] inline void findAttained(const Surroundings& surface, BlockValues& slopes) {
    for (int j = 0; j < kBlockSize; ++j)
        for (int i = 0; i < kBlockSize; i += kLanes) {
            const Squares squares = squaresAt(surface, i, j);
            Lanes steepest{};
            forEachCell(squares, [&](int x, int y) {
                steepest = larger(steepest,
                                  attainedBetween(squares, CellLanes(squares.texel, x, y), x, y));
            });
            storeLanes(squareRoots(steepest), &slopes[blockIndex(i, j)]);
        }
}

// The most that the depth may grow at the ends in a cell of chords of the sector, the steps of
// which are in the range; −kUnbounded where there are no such chords.
inline Lanes growthWithin(const Squares& squares, const CellLanes& cell, StepRange<float> steps) {
    if (!keepInSector(squares, steps))
        return splat(-kUnbounded);
    return mostGrowth(gradientBox(cell.depth, Lanes{}, Lanes{}, splat(1.0f), splat(1.0f)), steps);
}

// The squares of bounds on the slopes of chords from squares to cells that do not touch them.
inline Lanes boundBetween(const Squares& squares, int x, int y) {
    const CellLanes cell(squares.texel, x, y);
    const CornerSteps<float> across = cornerSteps(static_cast<float>(x));
    const CornerSteps<float> down = cornerSteps(static_cast<float>(y));
    float perSquare[3][3];
    reciprocals(across, down, squares.aspect, 0.5f * (1.0f + squares.aspect * squares.aspect),
                perSquare);
    const SquareToCell pair = squareToCell(squares.patch, across, down, cell.depth);
    Lanes chords{};
    Lanes tangents{};
    for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a) {
            chords = larger(chords, pair.chords[b][a] * pair.chords[b][a] * perSquare[b][a]);
            tangents =
                larger(tangents, pair.tangents[b][a] * pair.tangents[b][a] * perSquare[b][a]);
        }
    Lanes growth = pair.growth;
    if (!squares.sector.isAll())
        growth = smaller(
            growth,
            growthWithin(squares, cell, {{across.at[0], down.at[0]}, {across.at[2], down.at[2]}}));
    return growth > Lanes{} ? smaller(chords, tangents) : Lanes{};
}

// The least box around gradients, in the metric.
struct GradientHull {
    Lanes leastX = splat(kUnbounded);
    Lanes mostX = splat(-kUnbounded);
    Lanes leastY = splat(kUnbounded);
    Lanes mostY = splat(-kUnbounded);

    void add(const CellLanes& cell, float aspect) {
        const Lanes x[2] = {cell.depth[1] - cell.depth[0], cell.depth[3] - cell.depth[2]};
        const Lanes y[2] = {(cell.depth[2] - cell.depth[0]) / aspect,
                            (cell.depth[3] - cell.depth[1]) / aspect};
        leastX = smaller(leastX, smaller(x[0], x[1]));
        mostX = larger(mostX, larger(x[0], x[1]));
        leastY = smaller(leastY, smaller(y[0], y[1]));
        mostY = larger(mostY, larger(y[0], y[1]));
    }
    // The square of how far they differ at most. No chord among them along which a ray comes out
    // is steeper: its slope is a mean of −∇D·e, which is at most (∇D(y) − ∇D)·e at its end y.
    [[nodiscard]] Lanes difference() const {
        return squareOf(mostX - leastX) + squareOf(mostY - leastY);
    }
};

// The gradients in the cells from (left,top) to (right,bottom).
inline Lanes gradientDifference(const Squares& squares, int left, int top, int right, int bottom) {
    GradientHull hull;
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x)
            hull.add(CellLanes(squares.texel, x, y), squares.aspect);
    return hull.difference();
}

// The squares of bounds on the slopes of chords from a quarter of each square to a cell.
inline Lanes quarterBound(const Squares& squares, int quarter, int x, int y) {
    const int column = quarter % 2;
    const int row = quarter / 2;
    const CellLanes cell(squares.texel, x, y);
    const Lanes growthX[2] = {cell.depth[1] - cell.depth[0], cell.depth[3] - cell.depth[2]};
    const Lanes growthY[2] = {cell.depth[2] - cell.depth[0], cell.depth[3] - cell.depth[1]};
    const float correction = 0.25f * 1.25f * (1.0f + squares.aspect * squares.aspect);
    Lanes growth = splat(-kUnbounded);
    Lanes chords{};
    Lanes tangents{};
#pragma GCC unroll 4
    for (int l = 0; l < 4; ++l)
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            const float dx =
                static_cast<float>(x + l % 2) - 0.5f * static_cast<float>(column - 1 + k % 2);
            const float dy =
                static_cast<float>(y + l / 2) - 0.5f * static_cast<float>(row - 1 + k / 2);
            const float height = dy * squares.aspect;
            const float perSquare = reciprocal(dx * dx + height * height - correction);
            const Lanes grows = dx * growthX[l / 2] + dy * growthY[l % 2];
            const Lanes rises = squares.depths.at[row + k / 2][column + k % 2] - cell.depth[l];
            growth = larger(growth, grows);
            chords = larger(chords, squareOf(larger(rises, Lanes{})) * perSquare);
            tangents = larger(tangents, squareOf(larger(rises + grows, Lanes{})) * perSquare);
        }
    Lanes bound = smaller(chords, tangents);
    const int ownX = column - 1;
    const int ownY = row - 1;
    if (!squares.sector.isAll()) {
        const float firstX = static_cast<float>(x) - 0.5f * static_cast<float>(column);
        const float firstY = static_cast<float>(y) - 0.5f * static_cast<float>(row);
        growth = smaller(growth, growthWithin(squares, cell,
                                              {{firstX, firstY}, {firstX + 1.5f, firstY + 1.5f}}));
    }
    if (std::abs(x - ownX) <= 1 && std::abs(y - ownY) <= 1)
        bound = smaller(bound, gradientDifference(squares, std::min(x, ownX), std::min(y, ownY),
                                                  std::max(x, ownX), std::max(y, ownY)));
    return growth > Lanes{} ? bound : Lanes{};
}

// The search of sixteen texels. Level by level: all open pairs are bounded, then those whose bound
// may be much more than what some chord attains are halved, so that what is found for a texel does
// not depend on those beside it.
template <bool kInSector>
class NearCrestSearch {
  public:
    // `known`: squared slopes that are attained.
    NearCrestSearch(const Surroundings& surface, const float* texel, Lanes known, OpenPairs& open)
        : depths_(surface.depths.data()),
          left_(static_cast<int>(texel - depths_) % Surroundings::kSide),
          top_(static_cast<int>(texel - depths_) / Surroundings::kSide),
          aspect_(surface.aspect),
          sector_(surface.sector),
          open_(open) {
        storeLanes(known, attained_);
        storeLanes(known, accepted_);
    }

    void openFrom(const Squares& squares) {
        open_.pairs.clear();
        const Lanes known = loadLanes(attained_);
        const CellSpan across = cellsAhead(sector_.signX, -kBeside - 1, kBeside);
        const CellSpan down = cellsAhead(sector_.signY, -kBeside - 1, kBeside);
        const bool besideMatters = anyLane(
            gradientDifference(squares, across.first, down.first, across.last, down.last) > known);
        forEachCell(squares, [&](int x, int y) {
            if (!isBeside(x, y))
                openQuarters(boundBetween(squares, x, y) > known, x, y);
            else if (besideMatters)
                openBeside(squares, known, x, y);
        });
    }

    // The squares of the slopes.
    Lanes run() {
        while (!open_.pairs.empty()) {
            boundPairs();
            acceptPairs();
            halvePairs();
        }
        return larger(loadLanes(attained_), loadLanes(accepted_));
    }
    [[nodiscard]] std::uint64_t pairs() const { return pairs_; }

  private:
    // A quarter of the square, which lies in one of the cells around the texel's centre.
    void open(LaneMask lanes, int quarter, int x, int y) {
        if (!anyLane(lanes))
            return;
        const int fromX = left_ * kParts + (quarter % 2 - 1) * (kParts / 2);
        const int fromY = top_ * kParts + (quarter / 2 - 1) * (kParts / 2);
        const int toX = (left_ + x) * kParts;
        const int toY = (top_ + y) * kParts;
        for (int k = 0; k < kLanes; ++k)
            if (lanes[k] != 0)
                open_.pairs.push_back({pieceAt(fromX + k * kParts, fromY, kParts / 2),
                                       pieceAt(toX + k * kParts, toY, kParts),
                                       static_cast<std::uint32_t>(k)});
    }
    // In parts of texels.
    static Piece pieceAt(int x, int y, int side) {
        return {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                static_cast<std::uint16_t>(side)};
    }
    void openQuarters(LaneMask lanes, int x, int y) {
        for (int quarter = 0; quarter < 4; ++quarter)
            open(lanes, quarter, x, y);
    }
    void openBeside(const Squares& squares, Lanes known, int x, int y) {
        for (int quarter = 0; quarter < 4; ++quarter)
            open(quarterBound(squares, quarter, x, y) > known, quarter, x, y);
    }

    void boundPairs() {
        std::vector<Pair>& pairs = open_.pairs;
        const std::size_t count = pairs.size();
        pairs.resize(count + kLanes - 1, pairs.back());  // for the last registers
        open_.bounds.resize(pairs.size());
        for (std::size_t first = 0; first < count; first += kLanes) {
            const PairLanes some = loadPairs(&pairs[first], depths_);
            const PairSlopes slopes = pairSlopes<kInSector>(some, depths_, aspect_, sector_,
                                                            gatherLanes(accepted_, some.texel));
            storeLanes(slopes.bound, &open_.bounds[first]);
            alignas(64) float attained[kLanes];
            storeLanes(slopes.attained, attained);
            for (std::size_t k = 0; k < kLanes; ++k) {
                float& most = attained_[pairs[first + k].texel];
                most = std::max(most, attained[k]);
            }
        }
        pairs.resize(count);
        pairs_ += count;
    }

    // Bounds that are nearly attained, or of pieces that are small enough, are taken as they are;
    // so are all of a texel that has too many.
    void acceptPairs() {
        std::array<int, kLanes> left{};
        const auto isGoodEnough = [&](std::size_t k) {
            const Pair& pair = open_.pairs[k];
            return open_.bounds[k] <= attained_[pair.texel] * (kAccepted * kAccepted) ||
                   std::max(pair.from.side, pair.to.side) == 1;
        };
        for (std::size_t k = 0; k < open_.pairs.size(); ++k) {
            const std::uint32_t texel = open_.pairs[k].texel;
            if (isGoodEnough(k))
                accepted_[texel] = std::max(accepted_[texel], open_.bounds[k]);
            else
                ++left[texel];
        }
        for (std::size_t k = 0; k < open_.pairs.size(); ++k) {
            const std::uint32_t texel = open_.pairs[k].texel;
            if (left[texel] > kMostPairs)
                accepted_[texel] = std::max(accepted_[texel], open_.bounds[k]);
        }
    }

    void halvePairs() {
        open_.halves.clear();
        for (std::size_t k = 0; k < open_.pairs.size(); ++k) {
            const Pair& pair = open_.pairs[k];
            if (open_.bounds[k] > std::max(accepted_[pair.texel], attained_[pair.texel]))
                halve(pair);
        }
        std::swap(open_.pairs, open_.halves);
    }

    // The larger piece in quarters.
    void halve(const Pair& pair) {
        Piece Pair::*const larger = pair.to.side >= pair.from.side ? &Pair::to : &Pair::from;
        const Piece whole = pair.*larger;
        const int side = whole.side / 2;
        for (int quarter = 0; quarter < 4; ++quarter) {
            Pair half = pair;
            half.*larger =
                pieceAt(whole.x + quarter % 2 * side, whole.y + quarter / 2 * side, side);
            open_.halves.push_back(half);
        }
    }

    const float* depths_;
    int left_;  // of the first texel in the surroundings
    int top_;
    float aspect_;
    ChordSector sector_;
    OpenPairs& open_;
    alignas(64) float attained_[kLanes];  // by a chord
    alignas(64) float accepted_[kLanes];  // the greatest bound that was good enough
    std::uint64_t pairs_ = 0;
};

template <bool kInSector>
void refineBlock(const Surroundings& surface, OpenPairs& open, std::uint64_t& pairs, int width,
                 int height, BlockValues& slopes) {
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; i += kLanes) {
            const Squares squares = squaresAt(surface, i, j);
            float* const known = &slopes[blockIndex(i, j)];
            NearCrestSearch<kInSector> search(surface, squares.texel, squareOf(loadLanes(known)),
                                              open);
            search.openFrom(squares);
            storeLanes(larger(squareRoots(search.run()), loadLanes(known)), known);
            pairs += search.pairs();
        }
}

[[gnu::flatten]] inline void refineNearCrests(const Surroundings& surface, OpenPairs& open,
                                              std::uint64_t& pairs, int width, int height,
                                              BlockValues& slopes) {
    if (surface.sector.isAll())
        refineBlock<false>(surface, open, pairs, width, height, slopes);
    else
        refineBlock<true>(surface, open, pairs, width, height, slopes);
}
