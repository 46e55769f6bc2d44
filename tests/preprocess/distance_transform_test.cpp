#include "preprocess/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "tests/preprocess/random_set.h"
#include "tests/preprocess/thread_limit.h"
#include "textures/input_error.h"

namespace relievo::preprocess {
namespace {

using textures::WrapMode;

using Set = std::vector<std::uint8_t>;

// By trying every texel of the tile and its eight neighbours.
std::uint32_t bruteForce(const Set& set, int width, int height, WrapMode wrap, int i, int j) {
    std::uint32_t least = SquaredDistances::kUnlimited;
    for (int y = -height; y < 2 * height; ++y)
        for (int x = -width; x < 2 * width; ++x) {
            const auto texel = static_cast<std::size_t>(wrapIndex(y, height, wrap) * width +
                                                        wrapIndex(x, width, wrap));
            const std::int64_t across = x - i;
            const std::int64_t down = y - j;
            if (set[texel] != 0)
                least = std::min(least, static_cast<std::uint32_t>(across * across + down * down));
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
    for (const std::uint32_t distance : distancesTo(Set(15, 0), 5, 3, WrapMode::Repeat).texels)
        EXPECT_EQ(distance, SquaredDistances::kUnlimited);
}

// Envelopes with long stretches and large numbers: few texels in sets as wide as a stripe of
// columns and wider, against the distances to each of them.
TEST(DistanceTransform, EqualsBruteForceFarFromSparseSets) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] : {std::pair{64, 300}, {331, 67}, {129, 128}})
            for (const int count : {1, 2, 5, 30}) {
                std::mt19937 generator(static_cast<std::uint32_t>(count));
                Set set(static_cast<std::size_t>(width * height), 0);
                std::vector<std::size_t> places;
                for (int k = 0; k < count; ++k)
                    set[places.emplace_back(generator() % set.size())] = 1;
                const SquaredDistances distances = distancesTo(set, width, height, wrap);
                std::size_t wrong = 0;
                for (std::size_t k = 0; k < set.size(); ++k) {
                    const auto texel = [&, columns = width](std::size_t index) {
                        return std::pair{static_cast<int>(index) % columns,
                                         static_cast<int>(index) / columns};
                    };
                    std::uint32_t least = SquaredDistances::kUnlimited;
                    for (const std::size_t place : places) {
                        int across = std::abs(texel(place).first - texel(k).first);
                        int down = std::abs(texel(place).second - texel(k).second);
                        if (wrap == WrapMode::Repeat) {
                            across = std::min(across, width - across);
                            down = std::min(down, height - down);
                        }
                        least = std::min(least,
                                         static_cast<std::uint32_t>(across * across + down * down));
                    }
                    wrong += distances.texels[k] != least ? 1 : 0;
                }
                EXPECT_EQ(wrong, 0u) << width << "x" << height << " " << wrapModeName(wrap);
            }
}

TEST(DistanceTransform, ReachesAcrossTheLongestMaps) {
    constexpr int kLongest = 65534;
    Set set(kLongest, 0);
    set[0] = 1;
    for (const bool upright : {false, true}) {
        const SquaredDistances distances =
            distancesTo(set, upright ? 1 : kLongest, upright ? kLongest : 1, WrapMode::Clamp);
        for (const std::size_t place : {1u, 40000u, 65533u})
            EXPECT_EQ(distances.texels[place], place * place);
    }
}

TEST(DistanceTransform, RefusesMapsThatItsNumbersDoNotHold) {
    EXPECT_THROW(distancesTo(Set(65535, 1), 65535, 1, WrapMode::Clamp), textures::InputError);
}

TEST(DistanceTransform, UsesMemoryAgainThatHeldALargerMap) {
    SquaredDistances distances = distancesTo(Set(40 * 50, 1), 40, 50, WrapMode::Clamp);
    const Set set = randomSet(17, 13, 20, 2);
    measureDistances(set, 17, 13, WrapMode::Repeat, distances);
    EXPECT_EQ(distances.texels.size(), set.size());
    EXPECT_EQ(countWrong(distances, set, WrapMode::Repeat), 0u);
}

TEST(DistanceTransform, IsTheSameForOneAndTwoThreads) {
    const Set set = randomSet(150, 90, 300, 8);
    const auto measure = [&] { return distancesTo(set, 150, 90, WrapMode::Repeat).texels; };
    EXPECT_EQ(onThreads(1, measure), onThreads(2, measure));
}

TEST(DistanceTransform, IsCaughtWhenItForgetsToRepeat) {
    const Set set = randomSet(24, 31, 40, 1);
    EXPECT_GT(countWrong(distancesTo(set, 24, 31, WrapMode::Clamp), set, WrapMode::Repeat), 0u);
}

}  // namespace
}  // namespace relievo::preprocess
