#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace relievo::preprocess {

/// Sixteen floats that are worked on at once: one AVX-512 register, two of AVX, four of SSE. The
/// compiler's own vectors, so that the same source serves every processor
/// (for_each_processor.h); functions on them are in lane_operations.h.
inline constexpr int kLanes = 16;
using Lanes = float __attribute__((vector_size(64)));
using LaneMask = std::int32_t __attribute__((vector_size(64)));  ///< −1 where true, 0 where not

/// Four of them, as there are children of a node.
using Four = float __attribute__((vector_size(16)));
using FourMask = std::int32_t __attribute__((vector_size(16)));

}  // namespace relievo::preprocess
