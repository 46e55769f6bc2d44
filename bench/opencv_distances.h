#pragma once

#include "bench/bake_builders.h"

namespace relievo::bench {

#ifdef RELIEVO_HAS_OPENCV

/// Distances to the raised texels by OpenCV's precise transform (DIST_L2, DIST_MASK_PRECISE), which
/// knows no repeated maps. It may use as many threads as oneTBB.
BakeOutput buildOpenCvDistances(const BakeInput& input);

/// Signed distances to the border between raised and lowered texels, by that transform of either
/// side, and their slopes by Sobel's filter of 3×3.
BakeOutput buildOpenCvShape(const BakeInput& input);

inline constexpr auto kOpenCvDistances = buildOpenCvDistances;
inline constexpr auto kOpenCvShape = buildOpenCvShape;

#else

inline constexpr BakeOutput (*kOpenCvDistances)(const BakeInput& input) = nullptr;
inline constexpr BakeOutput (*kOpenCvShape)(const BakeInput& input) = nullptr;

#endif

}  // namespace relievo::bench
