// Bounds on the slopes of chords between two pieces of the surface (near_crests.h), for sixteen
// pairs of pieces at once. No include guard: see for_each_processor.h.

#include "preprocess/square_surface_kernel.h"

using Pair = NearCrests::Pair;
using Piece = NearCrests::Piece;

constexpr Lanes squareOf(Lanes value) {
    return value * value;
}

// Sixteen square parts of cells: where in the cells, and the cells' depths at their corners.
struct PieceLanes {
    Lanes u;
    Lanes v;
    Lanes side;
    Lanes cell[4];
};

struct PairLanes {
    PieceLanes from;
    PieceLanes to;
    LaneMask cellsX;  // cells from the one to the other
    LaneMask cellsY;
    LaneMask fromCell;  // the place of its first corner in Surroundings::depths
    LaneMask texel;
    Lanes stepX;
    Lanes stepY;
};

// Four words of each of sixteen pairs, transposed.
struct PairWords {
    LaneMask word[4];
};
inline PairWords loadPairWords(const Pair* pairs) {
    static_assert(sizeof(Pair) == 4 * sizeof(std::int32_t));
    LaneMask four[4];  // pairs, one after the other
    std::memcpy(four, pairs, sizeof(four));
    const auto both = [](LaneMask a, LaneMask b, int word) {
        return __builtin_shuffle(
            a, b, LaneMask{0, 4, 8, 12, 16, 20, 24, 28, 0, 4, 8, 12, 16, 20, 24, 28} + word);
    };
    const auto transposed = [&](int word) {
        return __builtin_shuffle(both(four[0], four[1], word), both(four[2], four[3], word),
                                 LaneMask{0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23});
    };
    return {{transposed(0), transposed(1), transposed(2), transposed(3)}};
}

inline void loadCells(const float* depths, LaneMask place, Lanes cell[4]) {
    cell[0] = gatherLanes(depths, place);
    cell[1] = gatherLanes(depths + 1, place);
    cell[2] = gatherLanes(depths + Surroundings::kSide, place);
    cell[3] = gatherLanes(depths + Surroundings::kSide + 1, place);
}

// From parts of texels.
inline Lanes toTexels(LaneMask parts) {
    return __builtin_convertvector(parts, Lanes) * (1.0f / NearCrests::kParts);
}

inline PairLanes loadPairs(const Pair* pairs, const float* depths) {
    const PairWords words = loadPairWords(pairs);
    const auto low = [&](int k) { return words.word[k] & 0xffff; };
    const auto high = [&](int k) { return words.word[k] >> 16; };
    constexpr int kWhole = ~(NearCrests::kParts - 1);
    const auto pieceAt = [&](LaneMask x, LaneMask y, LaneMask side, LaneMask place) {
        PieceLanes piece{toTexels(x & ~kWhole), toTexels(y & ~kWhole), toTexels(side), {}};
        loadCells(depths, place, piece.cell);
        return piece;
    };
    const LaneMask fromX = low(0);
    const LaneMask fromY = high(0);
    const LaneMask toX = high(1);
    const LaneMask toY = low(2);
    const auto place = [](LaneMask x, LaneMask y) {
        return y / NearCrests::kParts * Surroundings::kSide + x / NearCrests::kParts;
    };
    PairLanes result;
    result.fromCell = place(fromX, fromY);
    result.from = pieceAt(fromX, fromY, low(1), result.fromCell);
    result.to = pieceAt(toX, toY, high(2), place(toX, toY));
    result.cellsX = toX / NearCrests::kParts - fromX / NearCrests::kParts;
    result.cellsY = toY / NearCrests::kParts - fromY / NearCrests::kParts;
    result.stepX = __builtin_convertvector(result.cellsX, Lanes);
    result.stepY = __builtin_convertvector(result.cellsY, Lanes);
    result.texel = words.word[3];
    return result;
}

// Gradients in a part of a cell, in depth per texel width along x and per texel height along y: a
// box. ∂D/∂x on its upper and lower side, ∂D/∂y on its left and right one.
struct GradientBox {
    Lanes x[2];
    Lanes y[2];
};

// Of the part from (u0,v0) to (u1,v1).
inline GradientBox gradientBox(const Lanes cell[4], Lanes u0, Lanes v0, Lanes u1, Lanes v1) {
    const Lanes alongX = cell[1] - cell[0];
    const Lanes alongY = cell[2] - cell[0];
    const Lanes twist = cell[3] - cell[2] - alongX;
    return {{alongX + twist * v0, alongX + twist * v1}, {alongY + twist * u0, alongY + twist * u1}};
}

// The most that the depth may grow over steps of the range, by gradients of the box.
template <typename Length>
Lanes mostGrowth(const GradientBox& box, const StepRange<Length>& steps) {
    const auto most = [](const Lanes(&growth)[2], Length first, Length last) {
        return larger(larger(growth[0] * first, growth[0] * last),
                      larger(growth[1] * first, growth[1] * last));
    };
    return most(box.x, steps.first[0], steps.last[0]) + most(box.y, steps.first[1], steps.last[1]);
}

struct PieceSurface {
    GradientBox gradients;
    Lanes depth[4];  // at the corners
};

inline PieceSurface surfaceOf(const PieceLanes& piece) {
    const GradientBox box =
        gradientBox(piece.cell, piece.u, piece.v, piece.u + piece.side, piece.v + piece.side);
    const Lanes origin =
        piece.cell[0] + box.x[0] * piece.u + (piece.cell[2] - piece.cell[0]) * piece.v;
    const Lanes below = origin + box.y[0] * piece.side;
    return {box, {origin, origin + box.x[0] * piece.side, below, below + box.x[1] * piece.side}};
}

// The most that the depth may grow at the ends of chords of the sector from one piece into the
// other one, `dx` and `dy` from first corner to first corner; −kUnbounded where there are no such
// chords.
inline Lanes growthWithin(const ChordSector& sector, float aspect, const PairLanes& pair,
                          const GradientBox& gradients, Lanes dx, Lanes dy) {
    StepRange<Lanes> steps{{dx - pair.from.side, dy - pair.from.side},
                           {dx + pair.to.side, dy + pair.to.side}};
    keepInSector(sector, aspect, steps);
    const LaneMask exists = (steps.first[0] <= steps.last[0]) & (steps.first[1] <= steps.last[1]);
    return exists ? mostGrowth(gradients, steps) : splat(-kUnbounded);
}

// Which steps, of so many texels, are in the sector.
inline LaneMask isInSector(const ChordSector& sector, float aspect, Lanes x, Lanes y) {
    const Lanes alongX = x * sector.signX;
    const Lanes alongY = y * (sector.signY * aspect);
    const LaneMask isAhead = (alongX >= Lanes{}) & (alongY >= Lanes{});
    if (sector.half == ChordSector::Half::Shallow)
        return isAhead & (alongY <= alongX);
    if (sector.half == ChordSector::Half::Steep)
        return isAhead & (alongX <= alongY);
    return isAhead;
}

// What the sixteen pairs of corners of each pair of pieces say: maxima of squared slopes. Of a
// sector, corners beyond it help to bound chords, but are no ends of such that are attained.
struct CornerSlopes {
    Lanes chords;    // bounds by the surface
    Lanes tangents;  // and by the planes that touch it at the end
    Lanes attained;  // by a chord along which a ray comes out
    Lanes growth;    // positive where a ray may come out
};

template <bool kInSector>
CornerSlopes cornerSlopes(const PairLanes& pair, float aspect, const ChordSector& sector) {
    const PieceSurface from = surfaceOf(pair.from);
    const PieceSurface to = surfaceOf(pair.to);
    const Lanes correction =
        (squareOf(pair.from.side) + squareOf(pair.to.side)) * (0.25f * (1.0f + aspect * aspect));
    const Lanes dx = pair.stepX + pair.to.u - pair.from.u;
    const Lanes dy = pair.stepY + pair.to.v - pair.from.v;
    CornerSlopes result{{}, {}, {}, splat(-kUnbounded)};
#pragma GCC unroll 4
    for (int l = 0; l < 4; ++l)
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            const Lanes x = dx + (l % 2 != 0 ? pair.to.side : Lanes{}) -
                            (k % 2 != 0 ? pair.from.side : Lanes{});
            const Lanes y = dy + (l / 2 != 0 ? pair.to.side : Lanes{}) -
                            (k / 2 != 0 ? pair.from.side : Lanes{});
            const Lanes growth = to.gradients.x[l / 2] * x + to.gradients.y[l % 2] * y;
            const Lanes rise = from.depth[k] - to.depth[l];
            const Lanes chord = squareOf(larger(rise, Lanes{}));
            const Lanes tangent = squareOf(larger(rise + growth, Lanes{}));
            const Lanes square = squareOf(x) + squareOf(y * aspect);
            const Lanes perLeast = 1.0f / larger(square - correction, splat(1.0f / kUnbounded));
            result.chords = larger(result.chords, chord * perLeast);
            result.tangents = larger(result.tangents, tangent * perLeast);
            const Lanes slope = chord / larger(square, splat(1.0f / kUnbounded));
            LaneMask isChord = (growth > Lanes{}) & (square > Lanes{});
            if constexpr (kInSector)
                isChord &= isInSector(sector, aspect, x, y);
            result.attained = larger(result.attained, isChord ? slope : Lanes{});
            result.growth = larger(result.growth, growth);
        }
    if constexpr (kInSector)
        result.growth =
            smaller(result.growth, growthWithin(sector, aspect, pair, to.gradients, dx, dy));
    return result;
}

// The greatest (a·e)² (near_crests.h) for a among the slopes down in `path` and e in the sector.
inline Lanes steepestWithin(const ChordSector& sector, const GradientBox& path) {
    const bool isSteep = sector.half == ChordSector::Half::Steep;
    Lanes steepest{};
    for (int k = 0; k < 4; ++k) {
        const Lanes x = path.x[k % 2] * -sector.signX;
        const Lanes y = path.y[k / 2] * -sector.signY;
        if (sector.half == ChordSector::Half::Both) {
            const Lanes ahead = squareOf(larger(x, Lanes{})) + squareOf(larger(y, Lanes{}));
            steepest = larger(steepest, ahead);
            continue;
        }
        // From the axis to the diagonal.
        const Lanes along = isSteep ? y : x;
        const Lanes across = isSteep ? x : y;
        const Lanes onAxis = squareOf(larger(along, Lanes{}));
        const Lanes onDiagonal = squareOf(larger(along + across, Lanes{})) * 0.5f;
        const Lanes inside = squareOf(along) + squareOf(across);
        steepest = larger(steepest, across < Lanes{} ? onAxis
                                    : across > along ? onDiagonal
                                                     : inside);
    }
    return steepest;
}

// The same for b in `end` and all e.
inline Lanes steepestTowards(const GradientBox& path, const GradientBox& end) {
    Lanes steepest{};
#pragma GCC unroll 4
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

inline Lanes clampToCell(Lanes place) {
    return smaller(larger(place, Lanes{}), splat(1.0f));
}

// The bound by gradients, squared, where the cells of both pieces touch: chords stay in the
// rectangle around them, which has parts in up to four cells.
template <bool kInSector>
Lanes boundByGradients(const PairLanes& pair, const float* depths, float aspect,
                       const ChordSector& sector) {
    const Lanes toX = pair.stepX + pair.to.u;
    const Lanes toY = pair.stepY + pair.to.v;
    const Lanes left = smaller(pair.from.u, toX);
    const Lanes right = larger(pair.from.u + pair.from.side, toX + pair.to.side);
    const Lanes top = smaller(pair.from.v, toY);
    const Lanes bottom = larger(pair.from.v + pair.from.side, toY + pair.to.side);
    const auto toMetric = [&](GradientBox box) {
        box.y[0] = box.y[0] / aspect;
        box.y[1] = box.y[1] / aspect;
        return box;
    };
    const GradientBox end = toMetric(gradientBox(
        pair.to.cell, pair.to.u, pair.to.v, pair.to.u + pair.to.side, pair.to.v + pair.to.side));
    Lanes steepest{};
    for (int n = 0; n < 4; ++n) {
        const bool isAcross = n % 2 != 0;
        const bool isDown = n / 2 != 0;
        if ((isAcross && !anyLane(pair.cellsX != LaneMask{})) ||
            (isDown && !anyLane(pair.cellsY != LaneMask{})))
            continue;
        const Lanes x = isAcross ? pair.stepX : Lanes{};
        const Lanes y = isDown ? pair.stepY : Lanes{};
        const LaneMask place = pair.fromCell + (isAcross ? pair.cellsX : LaneMask{}) +
                               (isDown ? pair.cellsY * Surroundings::kSide : LaneMask{});
        Lanes cell[4];
        loadCells(depths, place, cell);
        const GradientBox path =
            toMetric(gradientBox(cell, clampToCell(left - x), clampToCell(top - y),
                                 clampToCell(right - x), clampToCell(bottom - y)));
        Lanes slope = steepestTowards(path, end);
        if constexpr (kInSector)
            slope = smaller(slope, steepestWithin(sector, path));
        steepest = larger(steepest, slope);
    }
    return steepest;
}

// Squared slopes of sixteen pairs.
struct PairSlopes {
    Lanes bound;     // 0 where no ray comes out
    Lanes attained;  // by a chord
};

// `known`: bounds need not be less than this.
template <bool kInSector>
PairSlopes pairSlopes(const PairLanes& pair, const float* depths, float aspect,
                      const ChordSector& sector, Lanes known) {
    const CornerSlopes corners = cornerSlopes<kInSector>(pair, aspect, sector);
    Lanes bound = corners.growth > Lanes{} ? smaller(corners.chords, corners.tangents) : Lanes{};
    const LaneMask touch = (squareOf(pair.stepX) <= splat(1.0f)) &
                           (squareOf(pair.stepY) <= splat(1.0f)) & (bound > known);
    if (anyLane(touch))
        bound = touch ? smaller(bound, boundByGradients<kInSector>(pair, depths, aspect, sector))
                      : bound;
    return {bound, corners.attained};
}
