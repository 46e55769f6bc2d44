#pragma once

#include "bench/bake_builders.h"

namespace relievo::bench {

#ifdef RELIEVO_HAS_OPENCV

/// Distances to the raised texels by OpenCV's precise transform (DIST_L2, DIST_MASK_PRECISE), which
/// knows no repeated maps. It may use as many threads as oneTBB.
BakeOutput buildOpenCvDistances(const BakeInput& input);

inline constexpr auto kOpenCvDistances = buildOpenCvDistances;

#else

inline constexpr BakeOutput (*kOpenCvDistances)(const BakeInput& input) = nullptr;

#endif

}  // namespace relievo::bench
