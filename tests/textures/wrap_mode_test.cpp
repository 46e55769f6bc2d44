#include "textures/wrap_mode.h"

#include <gtest/gtest.h>

#include <vector>

namespace relievo::textures {
namespace {

/// The texel that stands for `index`, found by walking there one texel at a time.
int walk(std::int64_t index, int size, WrapMode mode) {
    int texel = 0;
    int direction = 1;
    const int way = index < 0 ? -1 : 1;
    for (std::int64_t i = 0; i != index; i += way) {
        const int next = texel + way * direction;
        if (next >= 0 && next < size)
            texel = next;
        else if (mode == WrapMode::Repeat)
            texel = next < 0 ? size - 1 : 0;
        else if (mode == WrapMode::Mirror)
            direction = -direction;
    }
    return texel;
}

TEST(WrapMode, AgreesWithWalkingTexelByTexel) {
    for (const WrapMode mode : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const int size : {1, 2, 3, 7, 8})
            for (int index = -40; index <= 40; ++index)
                EXPECT_EQ(wrapIndex(index, size, mode), walk(index, size, mode))
                    << wrapModeName(mode) << " " << index << " of " << size;
}

TEST(WrapMode, HoldsFarOutside) {
    constexpr std::int64_t kFar = 7'000'000'000'000;
    EXPECT_EQ(wrapIndex(kFar + 3, 7, WrapMode::Repeat), 3);
    EXPECT_EQ(wrapIndex(-kFar + 3, 7, WrapMode::Repeat), 3);
    EXPECT_EQ(wrapIndex(2 * kFar + 8, 7, WrapMode::Mirror), 5);
    EXPECT_EQ(wrapIndex(-kFar, 7, WrapMode::Clamp), 0);
    EXPECT_EQ(wrapIndex(kFar, 7, WrapMode::Clamp), 6);
}

TEST(WrapMode, NamesAreInverse) {
    for (const WrapMode mode : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        EXPECT_EQ(wrapModeFromName(wrapModeName(mode)), mode);
    EXPECT_FALSE(wrapModeFromName("Repeat"));
    EXPECT_FALSE(wrapModeFromName(""));
}

}  // namespace
}  // namespace relievo::textures
