#include "preprocess/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace relievo::preprocess {
namespace {

using textures::WrapMode;

using Set = std::vector<std::uint8_t>;

Set randomSet(int width, int height, unsigned oneIn, std::uint32_t seed) {
    std::mt19937 generator(seed);
    Set set(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::generate(set.begin(), set.end(),
                  [&] { return generator() % oneIn == 0 ? std::uint8_t{1} : std::uint8_t{0}; });
    return set;
}

// By trying every texel of the tile and its eight neighbours.
std::int64_t bruteForce(const Set& set, int width, int height, WrapMode wrap, int i, int j) {
    std::int64_t least = SquaredDistances::kUnlimited;
    for (int y = -height; y < 2 * height; ++y)
        for (int x = -width; x < 2 * width; ++x) {
            const auto texel = static_cast<std::size_t>(wrapIndex(y, height, wrap) * width +
                                                        wrapIndex(x, width, wrap));
            const std::int64_t across = x - i;
            const std::int64_t down = y - j;
            if (set[texel] != 0)
                least = std::min(least, across * across + down * down);
        }
    return least;
}

std::size_t countWrong(const SquaredDistances& distances, const Set& set, WrapMode wrap) {
    std::size_t wrong = 0;
    for (int j = 0; j < distances.height; ++j)
        for (int i = 0; i < distances.width; ++i)
            wrong += distances.texels[static_cast<std::size_t>(j * distances.width + i)] !=
                             bruteForce(set, distances.width, distances.height, wrap, i, j)
                         ? 1
                         : 0;
    return wrong;
}

TEST(DistanceTransform, EqualsBruteForce) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 9}, {10, 1}, {2, 2}, {17, 13}, {24, 31}})
            for (const unsigned oneIn : {1u, 4u, 40u, 4000u}) {
                const Set set = randomSet(width, height, oneIn, oneIn);
                EXPECT_EQ(countWrong(distancesTo(set, width, height, wrap), set, wrap), 0u)
                    << width << "x" << height << " " << wrapModeName(wrap) << " 1/" << oneIn;
            }
}

TEST(DistanceTransform, IsUnlimitedWithoutASet) {
    for (const std::int64_t distance : distancesTo(Set(15, 0), 5, 3, WrapMode::Repeat).texels)
        EXPECT_EQ(distance, SquaredDistances::kUnlimited);
}

TEST(DistanceTransform, IsCaughtWhenItForgetsToRepeat) {
    const Set set = randomSet(24, 31, 40, 1);
    EXPECT_GT(countWrong(distancesTo(set, 24, 31, WrapMode::Clamp), set, WrapMode::Repeat), 0u);
}

}  // namespace
}  // namespace relievo::preprocess
