#include "preprocess/oriented_distances.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <limits>

#include "preprocess/processor.h"

namespace relievo::preprocess {
namespace {

// As many as have room in one register of AVX-512 in double precision.
constexpr int kEight = 8;
using Doubles = double __attribute__((vector_size(64)));
using EightFloats = float __attribute__((vector_size(32)));
using EightInts = std::int32_t __attribute__((vector_size(32)));

}  // namespace
}  // namespace relievo::preprocess

#define RELIEVO_KERNEL "preprocess/oriented_distances_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {

void orientTexels(const OrientedTexels& texels) {
    RELIEVO_CALL_KERNEL(orientKernel, texels);
}

double makeDistancesSure(std::span<float> distances, int width, double longest) {
    return RELIEVO_CALL_KERNEL(makeSureKernel, distances, width, longest);
}

float towardsZero(double texels, int width) {
    const double length = texels / width;
    const auto rounded = static_cast<float>(length);
    // The float before one above 0 has the number before it.
    return rounded > length ? std::bit_cast<float>(std::bit_cast<std::uint32_t>(rounded) - 1)
                            : rounded;
}

}  // namespace relievo::preprocess
