// From the square of a texel to a cell, for sixteen squares: the bounds of crest_search.h. No
// include guard: see for_each_processor.h.

#include "preprocess/lane_operations.h"

constexpr float kUnbounded = 1e30f;

// Borders between the halves of quadrants are wider by this than what floats may do to them.
constexpr float kBorderSlack = 1.00001f;

// Steps in a rectangle, in texels: [0] columns, [1] rows.
template <typename Length>
struct StepRange {
    Length first[2];
    Length last[2];
};

// Leaves of the steps from `least` to `most` along an axis; counted along it, or against it.
template <typename Length>
void keepSteps(StepRange<Length>& steps, int axis, float sign, Length least, Length most) {
    const Length low = sign > 0.0f ? least : -most;
    const Length high = sign > 0.0f ? most : -least;
    steps.first[axis] = steps.first[axis] > low ? steps.first[axis] : low;
    steps.last[axis] = steps.last[axis] < high ? steps.last[axis] : high;
}

// Leaves of a range the least rectangle around its part in a sector; first > last without any.
template <typename Length>
void keepInSector(const ChordSector& sector, float aspect, StepRange<Length>& steps) {
    const float sign[2] = {sector.signX, sector.signY};
    const Length farthest[2] = {sign[0] > 0.0f ? steps.last[0] : -steps.first[0],
                                sign[1] > 0.0f ? steps.last[1] : -steps.first[1]};
    for (int axis = 0; axis < 2; ++axis)
        keepSteps(steps, axis, sign[axis], Length{}, farthest[axis]);
    if (sector.half == ChordSector::Half::Both)
        return;
    const int along = sector.half == ChordSector::Half::Shallow ? 0 : 1;
    const int across = 1 - along;
    const float ratio = (along == 0 ? 1.0f / aspect : aspect) * kBorderSlack;
    const Length nearest = sign[across] > 0.0f ? steps.first[across] : -steps.last[across];
    keepSteps(steps, across, sign[across], nearest, farthest[along] * ratio);
    keepSteps(steps, along, sign[along], nearest / ratio, farthest[along]);
}

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
