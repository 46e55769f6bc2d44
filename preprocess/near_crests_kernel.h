// The bounds of near_crests.h, compiled for each generation of processors: see
// for_each_processor.h, which is why there is no include guard.

#include "preprocess/square_to_cell_kernel.h"

using Piece = NearCrests::Piece;
using Pair = NearCrests::Pair;
using Surroundings = NearCrests::Surroundings;

template <typename Number>
constexpr Number squareOf(Number value) {
    return value * value;
}

// --- Sixteen texels at once: which cells matter ------------------------------------------------

// The nine depths of sixteen texels' squares every half texel.
struct SquareDepths {
    Lanes at[3][3];  // [y][x]
};

inline SquareDepths squareDepths(const float* texel) {
    SquareDepths depths;
    const auto mean = [&](int x, int y) {
        const std::ptrdiff_t across = x;
        const std::ptrdiff_t down = static_cast<std::ptrdiff_t>(y) * Surroundings::kSide;
        return (loadLanes(texel) + loadLanes(texel + across) + loadLanes(texel + down) +
                loadLanes(texel + across + down)) *
               0.25f;
    };
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            depths.at[y + 1][x + 1] = mean(x, y);
    return depths;
}

// Corners of a bilinear patch that is nowhere above the surface: the plane through the middles of
// the sides, lowered to the nine depths, of which pieces between are means.
inline void squareCorners(const SquareDepths& depths, Lanes corners[4]) {
    const Lanes slopeX = depths.at[1][2] - depths.at[1][0];
    const Lanes slopeY = depths.at[2][1] - depths.at[0][1];
    Lanes base = depths.at[1][1];
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
            base = larger(base, depths.at[y][x] - slopeX * (0.5f * static_cast<float>(x - 1)) -
                                    slopeY * (0.5f * static_cast<float>(y - 1)));
    for (int k = 0; k < 4; ++k)
        corners[k] =
            base + slopeX * (k % 2 == 0 ? -0.5f : 0.5f) + slopeY * (k / 2 == 0 ? -0.5f : 0.5f);
}

[[gnu::flatten]] inline void findSquareDepths(const Surroundings& surface,
                                              std::array<BlockValues, 4>& depth) {
    for (int j = 0; j < kBlockSize; ++j)
        for (int i = 0; i < kBlockSize; i += kLanes) {
            Lanes corners[4];
            squareCorners(squareDepths(surface.texel(i, j)), corners);
            for (std::size_t k = 0; k < 4; ++k)
                storeLanes(corners[k], &depth[k][blockIndex(i, j)]);
        }
}

// Sixteen cells, each at the same place beside its texel.
struct CellLanes {
    Lanes depth[4];

    CellLanes(const float* texel, int x, int y) {
        const float* const cell = texel + y * Surroundings::kSide + x;
        depth[0] = loadLanes(cell);
        depth[1] = loadLanes(cell + 1);
        depth[2] = loadLanes(cell + Surroundings::kSide);
        depth[3] = loadLanes(cell + Surroundings::kSide + 1);
    }
};

// Cells from −kBeside−1 to kBeside beside a texel are too near to its square for chords between
// corners: the square's four quarters are looked at one by one.
constexpr int kBeside = 1;
inline bool isBeside(int x, int y) {
    return x >= -kBeside - 1 && x <= kBeside && y >= -kBeside - 1 && y <= kBeside;
}

// Sixteen squares of texels beside each other.
struct Squares {
    const float* texel;
    float aspect;
    SquareDepths depths;
    Lanes patch[4];  // depths at the corners of a patch that is nowhere above the surface
};

inline Squares squaresAt(const Surroundings& surface, int i, int j) {
    const float* const texel = surface.texel(i, j);
    Squares squares{texel, surface.aspect, squareDepths(texel), {}};
    squareCorners(squares.depths, squares.patch);
    return squares;
}

// One over a squared length, from which a correction was taken.
inline float reciprocal(float square) {
    return square > 1e-6f ? 1.0f / square : kUnbounded;
}

// The same of the steps between corners, less `correction`.
inline void reciprocals(const CornerSteps<float>& across, const CornerSteps<float>& down,
                        float aspect, float correction, float perSquare[3][3]) {
    for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
            perSquare[b][a] =
                reciprocal(squareOf(across.at[a]) + squareOf(down.at[b] * aspect) - correction);
}

// The squares of the slopes of the steepest chords from corners of squares to corners of cells
// along which rays come out.
inline Lanes attainedBetween(const Squares& squares, const CellLanes& cell, int x, int y) {
    const CornerSteps<float> across = cornerSteps(static_cast<float>(x));
    const CornerSteps<float> down = cornerSteps(static_cast<float>(y));
    float perSquare[3][3];
    reciprocals(across, down, squares.aspect, 0.0f, perSquare);
    const Lanes growthX[2] = {cell.depth[1] - cell.depth[0], cell.depth[3] - cell.depth[2]};
    const Lanes growthY[2] = {cell.depth[2] - cell.depth[0], cell.depth[3] - cell.depth[1]};
    Lanes steepest{};
    for (int l = 0; l < 4; ++l)
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

// The squares of bounds on the slopes of chords from squares to cells that do not touch them.
inline Lanes boundBetween(const Squares& squares, const CellLanes& cell, int x, int y) {
    const CornerSteps<float> across = cornerSteps(static_cast<float>(x));
    const CornerSteps<float> down = cornerSteps(static_cast<float>(y));
    float perSquare[3][3];
    reciprocals(across, down, squares.aspect, 0.5f * (1.0f + squareOf(squares.aspect)), perSquare);
    const SquareToCell pair = squareToCell(squares.patch, across, down, cell.depth);
    Lanes chords{};
    Lanes tangents{};
    for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a) {
            chords = larger(chords, pair.chords[b][a] * pair.chords[b][a] * perSquare[b][a]);
            tangents =
                larger(tangents, pair.tangents[b][a] * pair.tangents[b][a] * perSquare[b][a]);
        }
    return pair.growth > Lanes{} ? smaller(chords, tangents) : Lanes{};
}

// Gradients of sixteen cells on their sides, in depth per texel width: along x on the upper and the
// lower side, along y on the left and the right one.
struct SideGradients {
    Lanes x[2];
    Lanes y[2];

    SideGradients(const CellLanes& cell, float aspect)
        : x{cell.depth[1] - cell.depth[0], cell.depth[3] - cell.depth[2]},
          y{(cell.depth[2] - cell.depth[0]) / aspect, (cell.depth[3] - cell.depth[1]) / aspect} {}

    // Of a part of the cells: −1 the first half along an axis, 1 the second, 0 all.
    [[nodiscard]] SideGradients part(int halfX, int halfY) const {
        SideGradients result = *this;
        if (halfY != 0)
            result.x[halfY < 0 ? 1 : 0] = (x[0] + x[1]) * 0.5f;
        if (halfX != 0)
            result.y[halfX < 0 ? 1 : 0] = (y[0] + y[1]) * 0.5f;
        return result;
    }
};

// The bound by gradients (near_crests.h), squared: those of `path` may lie on a chord, it ends
// among those of `end`.
inline Lanes boundByGradients(const SideGradients& path, const SideGradients& end) {
    Lanes steepest{};
    for (int l = 0; l < 4; ++l) {
        const Lanes bx = end.x[l % 2];
        const Lanes by = end.y[l / 2];
        const Lanes square = bx * bx + by * by;
        const LaneMask grows = square > splat(1e-30f);
        const Lanes perSquare = 1.0f / (grows ? square : splat(1.0f));
        for (int k = 0; k < 4; ++k) {
            const Lanes ax = path.x[k % 2];
            const Lanes ay = path.y[k / 2];
            const Lanes along = ax * bx + ay * by;
            const Lanes across = ax * by - ay * bx;
            const Lanes slope = along <= Lanes{} ? ax * ax + ay * ay : across * across * perSquare;
            steepest = larger(steepest, grows ? slope : Lanes{});
        }
    }
    return steepest;
}

// Which half of the cell of a quarter, −1 or 0 along an axis, chords from the quarter to cell `to`
// cross (SideGradients::part). The quarter is the half that is nearer to the texel's centre: across
// the centre the way leads through it alone, the other way through all of the cell.
constexpr int halfOnTheWay(int own, int to) {
    if ((own < 0) != (to > own))
        return 0;
    return own < 0 ? 1 : -1;
}

// The same for the chords from a quarter of each square to a cell that is the quarter's or beside
// it: they stay in the rectangle around both.
inline Lanes quarterBoundByGradients(const Squares& squares, int quarter, int x, int y) {
    const int ownX = quarter % 2 - 1;
    const int ownY = quarter / 2 - 1;
    const SideGradients end(CellLanes(squares.texel, x, y), squares.aspect);
    Lanes steepest = boundByGradients(end, end);
    const auto add = [&](int cellX, int cellY) {
        const SideGradients cell(CellLanes(squares.texel, cellX, cellY), squares.aspect);
        const SideGradients path = cell.part(cellX == x ? 0 : halfOnTheWay(ownX, x),
                                             cellY == y ? 0 : halfOnTheWay(ownY, y));
        steepest = larger(steepest, boundByGradients(path, end));
    };
    if (x != ownX)
        add(ownX, y);
    if (y != ownY)
        add(x, ownY);
    if (x != ownX && y != ownY)
        add(ownX, ownY);
    return steepest;
}

// The squares of bounds on the slopes of chords from a quarter of each square to a cell, and of the
// slopes that chords between corners attain.
inline Lanes quarterBound(const Squares& squares, int quarter, int x, int y, Lanes& attained) {
    const int column = quarter % 2;
    const int row = quarter / 2;
    const CellLanes cell(squares.texel, x, y);
    const Lanes growthX[2] = {cell.depth[1] - cell.depth[0], cell.depth[3] - cell.depth[2]};
    const Lanes growthY[2] = {cell.depth[2] - cell.depth[0], cell.depth[3] - cell.depth[1]};
    const float correction = 0.25f * 1.25f * (1.0f + squareOf(squares.aspect));
    Lanes growth = Lanes{} - kUnbounded;
    Lanes chords{};
    Lanes tangents{};
    for (int l = 0; l < 4; ++l)
        for (int k = 0; k < 4; ++k) {
            const float dx =
                static_cast<float>(x + l % 2) - 0.5f * static_cast<float>(column - 1 + k % 2);
            const float dy =
                static_cast<float>(y + l / 2) - 0.5f * static_cast<float>(row - 1 + k / 2);
            const float square = squareOf(dx) + squareOf(dy * squares.aspect);
            const float perSquare = reciprocal(square - correction);
            const Lanes grows = dx * growthX[l / 2] + dy * growthY[l % 2];
            const Lanes rises = squares.depths.at[row + k / 2][column + k % 2] - cell.depth[l];
            const Lanes chord = larger(rises, Lanes{});
            const Lanes tangent = larger(rises + grows, Lanes{});
            growth = larger(growth, grows);
            chords = larger(chords, chord * chord * perSquare);
            tangents = larger(tangents, tangent * tangent * perSquare);
            if (square > 0.0f)
                attained =
                    larger(attained, grows > Lanes{} ? chord * chord * (1.0f / square) : Lanes{});
        }
    Lanes bound = smaller(chords, tangents);
    if (std::abs(x - column + 1) <= 1 && std::abs(y - row + 1) <= 1)
        bound = smaller(bound, quarterBoundByGradients(squares, quarter, x, y));
    return growth > Lanes{} ? bound : Lanes{};
}

[[gnu::flatten]] inline void findAttained(const Surroundings& surface, BlockValues& slopes) {
    for (int j = 0; j < kBlockSize; ++j)
        for (int i = 0; i < kBlockSize; i += kLanes) {
            const Squares squares = squaresAt(surface, i, j);
            Lanes steepest{};
            for (int k = 0; k < kCells * kCells; ++k) {
                const int x = k % kCells - kReach - 1;
                const int y = k / kCells - kReach - 1;
                steepest = larger(steepest,
                                  attainedBetween(squares, CellLanes(squares.texel, x, y), x, y));
            }
            storeLanes(squareRoots(steepest), &slopes[blockIndex(i, j)]);
        }
}

// --- One pair of pieces: its sixteen pairs of corners at once ----------------------------------

// Depths and gradients of a cell: d(u,v) = origin + alongX·u + alongY·v + twist·u·v.
struct CellSurface {
    float origin;
    float alongX;
    float alongY;
    float twist;
};

inline CellSurface cellAt(const float* texel, int x, int y) {
    const float* const cell = texel + y * Surroundings::kSide + x;
    const float* const below = cell + Surroundings::kSide;
    const float alongX = cell[1] - cell[0];
    return {cell[0], alongX, below[0] - cell[0], (below[1] - below[0]) - alongX};
}

// The cell's depths as seen from the first corner of a piece of it, in parts of the piece's side.
inline CellSurface within(const CellSurface& cell, const Piece& piece) {
    const float u = piece.x - static_cast<float>(piece.cellX);
    const float v = piece.y - static_cast<float>(piece.cellY);
    return {cell.origin + cell.alongX * u + cell.alongY * v + cell.twist * (u * v),
            (cell.alongX + cell.twist * v) * piece.side,
            (cell.alongY + cell.twist * u) * piece.side, cell.twist * (piece.side * piece.side)};
}

// Lane 4·l + k: corner k of the one piece, corner l of the other.
struct CornerPattern {
    Lanes fromX = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
    Lanes fromY = {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};
    Lanes toX = {0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1};
    Lanes toY = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
};

struct PairSlopes {
    float bound;     // squared, 0 where no ray comes out
    float attained;  // squared, by a chord
};

// Gradients of the part of a cell between (x0,y0) and (x1,y1): a box.
struct PartGradients {
    float x[2];
    float y[2];
};
inline PartGradients partGradients(const CellSurface& cell, float u0, float v0, float u1, float v1,
                                   float aspect) {
    return {{cell.alongX + cell.twist * v0, cell.alongX + cell.twist * v1},
            {(cell.alongY + cell.twist * u0) / aspect, (cell.alongY + cell.twist * u1) / aspect}};
}

// The bound by gradients (near_crests.h), squared, for the rectangle around two pieces whose cells
// touch.
inline float boundByGradients(const Surroundings& surface, const float* texel, const Piece& from,
                              const Piece& to) {
    const float left = std::min(from.x, to.x);
    const float right = std::max(from.x + from.side, to.x + to.side);
    const float top = std::min(from.y, to.y);
    const float bottom = std::max(from.y + from.side, to.y + to.side);
    alignas(64) float downs[2][kLanes];
    for (int n = 0; n < 4; ++n) {
        const int cellX = n % 2 == 0 ? from.cellX : to.cellX;
        const int cellY = n / 2 == 0 ? from.cellY : to.cellY;
        const auto x = static_cast<float>(cellX);
        const auto y = static_cast<float>(cellY);
        const PartGradients box =
            partGradients(cellAt(texel, cellX, cellY), std::clamp(left - x, 0.0f, 1.0f),
                          std::clamp(top - y, 0.0f, 1.0f), std::clamp(right - x, 0.0f, 1.0f),
                          std::clamp(bottom - y, 0.0f, 1.0f), surface.aspect);
        for (int k = 0; k < 4; ++k) {
            downs[0][4 * n + k] = -box.x[k % 2];
            downs[1][4 * n + k] = -box.y[k / 2];
        }
    }
    const Lanes downX = loadLanes(downs[0]);
    const Lanes downY = loadLanes(downs[1]);
    const float u = to.x - static_cast<float>(to.cellX);
    const float v = to.y - static_cast<float>(to.cellY);
    const PartGradients after = partGradients(cellAt(texel, to.cellX, to.cellY), u, v, u + to.side,
                                              v + to.side, surface.aspect);
    Lanes steepest{};
    for (int l = 0; l < 4; ++l) {
        const float bx = after.x[l % 2];
        const float by = after.y[l / 2];
        const float square = bx * bx + by * by;
        if (!(square > 1e-30f))
            continue;
        const Lanes along = downX * bx + downY * by;
        const Lanes across = downX * by - downY * bx;
        steepest = larger(
            steepest, along >= Lanes{} ? downX * downX + downY * downY : across * across / square);
    }
    return largestLane(steepest);
}

// `known`: bounds need not be less than this.
inline PairSlopes slopesOf(const Surroundings& surface, const float* texel, const Piece& from,
                           const Piece& to, float known) {
    const CornerPattern corner;
    const CellSurface start = within(cellAt(texel, from.cellX, from.cellY), from);
    const CellSurface end = within(cellAt(texel, to.cellX, to.cellY), to);
    const Lanes startDepth = start.origin + start.alongX * corner.fromX +
                             start.alongY * corner.fromY +
                             start.twist * (corner.fromX * corner.fromY);
    const Lanes endDepth = end.origin + end.alongX * corner.toX + end.alongY * corner.toY +
                           end.twist * (corner.toX * corner.toY);
    const Lanes dx = (to.x - from.x) + corner.toX * to.side - corner.fromX * from.side;
    const Lanes dy = (to.y - from.y) + corner.toY * to.side - corner.fromY * from.side;
    const float perSide = 1.0f / to.side;  // a power of two
    const Lanes growth =
        ((end.alongX + end.twist * corner.toY) * dx + (end.alongY + end.twist * corner.toX) * dy) *
        perSide;
    const LaneMask comesOut = growth > Lanes{};
    if (!anyLane(comesOut))
        return {0.0f, 0.0f};
    const float aspect = surface.aspect;
    const float correction =
        (squareOf(from.side) + squareOf(to.side)) * 0.25f * (1.0f + squareOf(aspect));
    const Lanes square = dx * dx + dy * dy * squareOf(aspect);
    const Lanes rises = startDepth - endDepth;
    const Lanes attained =
        comesOut & (rises > Lanes{}) & (square > Lanes{}) ? rises * rises / square : Lanes{};
    const LaneMask isFar = square - correction > splat(1e-6f);
    const Lanes length = isFar ? square - correction : splat(1.0f);
    const auto bound = [&](Lanes rise) {
        return largestLane(rise > Lanes{} ? (isFar ? rise * rise / length : splat(kUnbounded))
                                          : Lanes{});
    };
    float least = bound(rises);
    if (least > known)
        least = std::min(least, bound(rises + growth));
    if (least > known && std::abs(from.cellX - to.cellX) <= 1 &&
        std::abs(from.cellY - to.cellY) <= 1)
        least = std::min(least, boundByGradients(surface, texel, from, to));
    return {least, largestLane(attained)};
}

// A part of a square: a quarter, 0 to 3, or all.
constexpr int kWhole = 4;

// --- One texel ---------------------------------------------------------------------------------

// The search of one texel: pairs are halved until none may be much steeper than what is attained.
class PairSearch {
  public:
    // `attained`: squared slopes of some chord to these cells, or known otherwise.
    PairSearch(const Surroundings& surface, const float* texel, float attained,
               std::vector<Pair>& stack)
        : surface_(surface),
          texel_(texel),
          attained_(attained),
          accepted_(attained),
          stack_(stack) {}

    // A part of the square and a whole cell.
    void search(int part, int x, int y, float bound) {
        if (bound <= accepted_)
            return;
        stack_.clear();
        stack_.push_back({part == kWhole ? Piece{-0.5f, -0.5f, 1.0f, 0, 0} : quarterOfSquare(part),
                          {static_cast<float>(x), static_cast<float>(y), 1.0f, x, y},
                          bound});
        while (!stack_.empty()) {
            const Pair pair = stack_.back();
            stack_.pop_back();
            if (pair.bound <= attained_ * squareOf(kAccepted) || pairs_ > kMostPairs ||
                std::max(pair.from.side, pair.to.side) <= kLeastSide)
                accepted_ = std::max(accepted_, pair.bound);
            else if (pair.bound > accepted_)
                split(pair);
        }
    }

    // The square of the slope.
    [[nodiscard]] float slope() const { return std::max(attained_, accepted_); }
    [[nodiscard]] int pairs() const { return pairs_; }

  private:
    // Sorted, the steepest on top of what was pushed since `first`.
    void add(const Piece& from, const Piece& to, std::size_t first) {
        ++pairs_;
        const PairSlopes slopes = slopesOf(surface_, texel_, from, to, accepted_);
        attained_ = std::max(attained_, slopes.attained);
        if (slopes.bound <= std::max(attained_, accepted_))
            return;
        const Pair pair{from, to, slopes.bound};
        std::size_t place = stack_.size();
        stack_.push_back(pair);
        for (; place > first && stack_[place - 1].bound > pair.bound; --place)
            stack_[place] = stack_[place - 1];
        stack_[place] = pair;
    }

    // The square of the texel has a part in each of the four cells around its centre.
    static Piece quarterOfSquare(int k) {
        const int cellX = k % 2 - 1;
        const int cellY = k / 2 - 1;
        return {0.5f * static_cast<float>(cellX), 0.5f * static_cast<float>(cellY), 0.5f, cellX,
                cellY};
    }
    static Piece quarter(const Piece& piece, int k) {
        const float side = 0.5f * piece.side;
        return {piece.x + (k % 2 == 0 ? 0.0f : side), piece.y + (k / 2 == 0 ? 0.0f : side), side,
                piece.cellX, piece.cellY};
    }

    void split(const Pair& pair) {
        const std::size_t first = stack_.size();
        for (int k = 0; k < 4; ++k)
            if (pair.from.side == 1.0f)
                add(quarterOfSquare(k), pair.to, first);
            else if (pair.to.side >= pair.from.side)
                add(pair.from, quarter(pair.to, k), first);
            else
                add(quarter(pair.from, k), pair.to, first);
    }

    const Surroundings& surface_;
    const float* texel_;
    float attained_;  // by a chord, or known
    float accepted_;  // the greatest bound that was good enough, or known
    std::vector<Pair>& stack_;
    int pairs_ = 0;
};

// Bounds of sixteen texels.
struct StartBounds {
    struct Start {
        int part;
        int x;
        int y;
    };
    static constexpr int kMost = kCells * kCells + 3 * squareOf(2 * kBeside + 2);
    int count = 0;
    Start starts[kMost];
    alignas(64) float bounds[kMost][kLanes];
    Lanes attained;  // by chords from quarters

    void add(int part, int x, int y, Lanes bound) {
        starts[count] = {part, x, y};
        storeLanes(bound, bounds[count++]);
    }
};

inline void findStartBounds(const Squares& squares, StartBounds& start) {
    start.count = 0;
    start.attained = Lanes{};
    for (int k = 0; k < kCells * kCells; ++k) {
        const int x = k % kCells - kReach - 1;
        const int y = k / kCells - kReach - 1;
        if (!isBeside(x, y))
            start.add(kWhole, x, y, boundBetween(squares, CellLanes(squares.texel, x, y), x, y));
        else
            for (int quarter = 0; quarter < 4; ++quarter)
                start.add(quarter, x, y, quarterBound(squares, quarter, x, y, start.attained));
    }
}

[[gnu::flatten]] inline void refineNearCrests(const Surroundings& surface, std::vector<Pair>& stack,
                                              std::uint64_t& pairs, int width, int height,
                                              BlockValues& slopes) {
    StartBounds start;
    for (int j = 0; j < height; ++j)
        for (int first = 0; first < width; first += kLanes) {
            const Squares squares = squaresAt(surface, first, j);
            findStartBounds(squares, start);
            for (int i = 0; i < std::min(kLanes, width - first); ++i) {
                float& known = slopes[blockIndex(first + i, j)];
                PairSearch search(surface, squares.texel + i,
                                  std::max(squareOf(known), start.attained[i]), stack);
                for (int k = 0; k < start.count; ++k)
                    search.search(start.starts[k].part, start.starts[k].x, start.starts[k].y,
                                  start.bounds[k][i]);
                known = std::max(known, std::sqrt(search.slope()));
                pairs += static_cast<std::uint64_t>(search.pairs());
            }
        }
}
