// From the square of a texel to a cell, for sixteen squares: the bounds of crest_search.h. No
// include guard: see for_each_processor.h.

#include "preprocess/lane_operations.h"

constexpr float kUnbounded = 1e30f;

// Steps from the corners of a square to those of a cell along one axis, in texels: index 1 + the
// cell's corner − the square's. Lanes, or a float where they are the same for all.
template <typename Length>
struct CornerSteps {
    Length at[3];
};

// `first`: the step from the centre of the square to the cell's first corner.
template <typename Length>
CornerSteps<Length> cornerSteps(Length first) {
    return {{first - 0.5f, first + 0.5f, first + 1.5f}};
}

// Maxima over all pairs of corners with the same steps, and the growth of the depth over the whole
// step by the gradient at its end.
struct SquareToCell {
    Lanes chords[3][3] = {};
    Lanes tangents[3][3] = {};
    Lanes growth = Lanes{} - kUnbounded;
};

// `corners`: depths of the square. `depth`: of the cell, in the order of ReliefQuad.
template <typename Length, typename Depth>
SquareToCell squareToCell(const Lanes* corners, const CornerSteps<Length>& across,
                          const CornerSteps<Length>& down, const Depth* depth) {
    const Depth growthX[2] = {depth[1] - depth[0], depth[3] - depth[2]};
    const Depth growthY[2] = {depth[2] - depth[0], depth[3] - depth[1]};
    SquareToCell result;
#pragma GCC unroll 4
    for (int l = 0; l < 4; ++l)
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            const int a = 1 + l % 2 - k % 2;
            const int b = 1 + l / 2 - k / 2;
            const Lanes grows = across.at[a] * growthX[l / 2] + down.at[b] * growthY[l % 2];
            const Lanes rises = corners[k] - depth[l];
            result.growth = larger(result.growth, grows);
            result.chords[b][a] = larger(result.chords[b][a], rises);
            result.tangents[b][a] = larger(result.tangents[b][a], rises + grows);
        }
    return result;
}
