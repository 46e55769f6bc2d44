#include "textures/large_pages.h"

#if defined(__linux__)
#include <sys/mman.h>

#include <cstdint>
#endif

namespace relievo::textures {

void reserveLargePages(std::vector<float>& values, std::size_t count) {
    values.reserve(count);
#if defined(__linux__)
    constexpr std::uintptr_t kLargePage = 1 << 21;
    const auto start = reinterpret_cast<std::uintptr_t>(values.data());
    const std::uintptr_t first = (start + kLargePage - 1) / kLargePage * kLargePage;
    const std::uintptr_t end = (start + count * sizeof(float)) / kLargePage * kLargePage;
    // A wish: without it, or where it is not granted, nothing but the time is different.
    if (first < end)
        ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace relievo::textures
