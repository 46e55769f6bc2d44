// The bounds of bilinear_slopes.h, compiled for each generation of processors: see
// for_each_processor.h, which is why there is no include guard.

#include "preprocess/steepest_chords_kernel.h"

using Lattices = BilinearSlopes::Lattices;

inline Lanes square(Lanes lanes) {
    return lanes * lanes;
}

// The finer lattices are needed in few blocks: they are sampled on demand.
inline const SampleLattice& filled(const Lattices& surface, SampleLattice& lattice,
                                   bool& isFilled) {
    if (!isFilled)
        lattice.fill(*surface.map, surface.left, surface.top);
    isFilled = true;
    return lattice;
}

// The steepest gradient in the square of a texel, widened by `margin` ≤ ½ on all sides.
inline Lanes steepestInside(const Lattices& surface, int i, int j, float margin) {
    const float* const centre = surface.halves.texel(i, j);
    const float part = 0.5f + margin;
    Lanes steepest{};
    for (const int y : {-2, 2})
        for (const int x : {-2, 2}) {
            const std::ptrdiff_t across = surface.halves.stepTo(x, 0);
            const std::ptrdiff_t down = surface.halves.stepTo(0, y);
            const Lanes middle = loadLanes(centre);
            const Lanes beside = loadLanes(centre + across);
            const Lanes under = loadLanes(centre + down);
            const Lanes opposite = loadLanes(centre + across + down);
            const Lanes alongX = beside - middle;
            const Lanes farAlongX = alongX + ((opposite - under) - alongX) * part;
            const Lanes alongY = (under - middle) / surface.aspect;
            const Lanes farAlongY = alongY + ((opposite - beside) / surface.aspect - alongY) * part;
            steepest = larger(steepest, larger(square(alongX), square(farAlongX)) +
                                            larger(square(alongY), square(farAlongY)));
        }
    return squareRoots(steepest);
}

// The steepest gradient in the cells around a texel, 2·radius in a row.
inline Lanes steepestCells(const Lattices& surface, int i, int j, int radius) {
    Lanes steepest{};
    for (int y = -radius; y < radius; ++y) {
        const float* const row =
            surface.cells.data() + (j + y + kCellBorder) * kCellSide + i + kCellBorder;
        for (int x = -radius; x < radius; ++x)
            steepest = larger(steepest, loadLanes(row + x));
    }
    return steepest;
}

inline Lanes coarse(const Lattices& surface, int i, int j) {
    return larger(steepestInside(surface, i, j, 0.0f),
                  smaller(steepestChords(surface.farChords, surface.halves.texel(i, j)),
                          steepestCells(surface, i, j, kReach)));
}

inline Lanes refined(Lattices& surface, int i, int j, Lanes known) {
    // A lane is settled once the gradients around add next to nothing; the lanes beside it may make
    // the others go on, but not change it.
    Lanes result{};
    LaneMask open = LaneMask{} - 1;
    const auto settle = [&](Lanes around) {
        const LaneMask settled = open & (around <= known * kWorthwhile);
        result = settled ? larger(known, around) : result;
        open &= ~settled;
        return !anyLane(open);
    };
    const auto steepen = [&](Lanes chords, Lanes around) {
        known = larger(known, smaller(chords, around));
    };
    const Lanes aroundHalves = steepestCells(surface, i, j, kCellsAroundHalves);
    if (settle(aroundHalves))
        return result;
    steepen(steepestChords(surface.halfChords, surface.halves.texel(i, j)), aroundHalves);

    const Lanes aroundQuarters = steepestCells(surface, i, j, kCellsAroundQuarters);
    if (settle(aroundQuarters))
        return result;
    steepen(steepestChords(surface.quarterChords,
                           filled(surface, surface.quarters, surface.hasQuarters).texel(i, j)),
            aroundQuarters);

    const Lanes aroundEighths = steepestCells(surface, i, j, kCellsAroundEighths);
    if (settle(aroundEighths))
        return result;
    steepen(steepestChords(surface.eighthChords,
                           filled(surface, surface.eighths, surface.hasEighths).texel(i, j)),
            aroundEighths);
    return open ? larger(known, steepestInside(surface, i, j, kMarginAroundEighths)) : result;
}

// A plane that is nowhere above the surface in the square of a texel (so: as deep or deeper), from
// its centre.
struct UpperPlane {
    Lanes base;
    Lanes slopeX;
    Lanes slopeY;
};

inline UpperPlane upperPlane(const Lattices& surface, int i, int j) {
    const float* const centre = surface.halves.texel(i, j);
    const auto at = [&](int x, int y) { return loadLanes(centre + surface.halves.stepTo(x, y)); };
    UpperPlane plane{{}, at(1, 0) - at(-1, 0), at(0, 1) - at(0, -1)};
    plane.base = at(0, 0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            plane.base =
                larger(plane.base, at(x, y) - plane.slopeX * (0.5f * static_cast<float>(x)) -
                                       plane.slopeY * (0.5f * static_cast<float>(y)));
    return plane;
}

inline Lanes cornerDepths(const Lattices& surface, int i, int j) {
    Lanes depth{};
    for (const int y : {-1, 0})
        for (const int x : {-1, 0}) {
            const UpperPlane plane = upperPlane(surface, i + x, j + y);
            const float across = x < 0 ? 0.5f : -0.5f;
            const float down = y < 0 ? 0.5f : -0.5f;
            depth = larger(depth, plane.base + plane.slopeX * across + plane.slopeY * down);
        }
    return depth;
}

// Calls use(i, j, index in BlockValues) for the first texels of the wanted groups.
template <typename Use>
void forGroups(const BlockGroups& wanted, const Use& use) {
    for (int j = 0; j < kBlockSize; ++j)
        for (int i = 0; i < kBlockSize; i += kLanes)
            if (const std::size_t index = blockIndex(i, j); wanted[index / kLanes])
                use(i, j, index);
}

[[gnu::flatten]] inline void findCoarseSlopes(const Lattices& surface, const BlockGroups& wanted,
                                              BlockValues& slopes) {
    forGroups(wanted, [&](int i, int j, std::size_t index) {
        storeLanes(coarse(surface, i, j), &slopes[index]);
    });
}

[[gnu::flatten]] inline void refineSlopes(Lattices& surface, const BlockGroups& wanted,
                                          BlockValues& slopes) {
    forGroups(wanted, [&](int i, int j, std::size_t index) {
        storeLanes(refined(surface, i, j, loadLanes(&slopes[index])), &slopes[index]);
    });
}

[[gnu::flatten]] inline void findCornerDepths(const Lattices& surface, const BlockGroups& wanted,
                                              BlockValues& depths) {
    forGroups(wanted, [&](int i, int j, std::size_t index) {
        storeLanes(cornerDepths(surface, i, j), &depths[index]);
    });
}
