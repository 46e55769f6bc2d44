// The surface at sixteen texels beside each other: the squares around them and the cells near
// these. No include guard: see for_each_processor.h.

#include "preprocess/square_to_cell_kernel.h"

using Surroundings = NearCrests::Surroundings;

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

// Sixteen squares of texels beside each other.
struct Squares {
    const float* texel;
    float aspect;
    ChordSector sector;  // of the chords that count
    SquareDepths depths;
    Lanes patch[4];  // depths at the corners of a patch that is nowhere above the surface
};

inline Squares squaresAt(const Surroundings& surface, int i, int j) {
    const float* const texel = surface.texel(i, j);
    Squares squares{texel, surface.aspect, surface.sector, squareDepths(texel), {}};
    squareCorners(squares.depths, squares.patch);
    return squares;
}
