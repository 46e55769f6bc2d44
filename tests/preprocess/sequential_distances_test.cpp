#include "preprocess/sequential_distances.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/preprocess/random_set.h"

namespace relievo::preprocess {
namespace {

using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

using Set = std::vector<std::uint8_t>;

DistanceErrors errorsOf(const Set& set, int width, int height, WrapMode wrap) {
    return compareDistances(sequentialDistances(set, width, height, wrap),
                            distancesTo(set, width, height, wrap));
}

TEST(SequentialDistances, AreRarelyAndSlightlyTooLargeNeverTooSmall) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 9}, {10, 1}, {2, 2}, {37, 53}, {160, 90}, {64, 3}})
            for (const unsigned oneIn : {1u, 4u, 40u, 400u}) {
                const Set set = randomSet(width, height, oneIn, oneIn);
                const DistanceErrors errors = errorsOf(set, width, height, wrap);
                EXPECT_EQ(errors.tooSmall, 0u) << width << "x" << height << " 1/" << oneIn;
                EXPECT_LE(errors.tooLarge, set.size() / 50) << width << "x" << height;
                EXPECT_LE(errors.greatest, 0.5) << width << "x" << height << " 1/" << oneIn;
            }
}

TEST(SequentialDistances, AreExactOnOneRowOrColumnAndFromOneTexel) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair{1, 41}, {40, 1}}) {
            const DistanceErrors errors =
                errorsOf(randomSet(width, height, 9, 3), width, height, wrap);
            EXPECT_EQ(errors.tooLarge + errors.tooSmall, 0u) << width << "x" << height;
        }
    for (const WrapMode wrap : kWraps)
        for (const std::size_t place : {0u, 36u, 500u, 37u * 23u - 1u}) {
            Set set(37 * 23, 0);
            set[place] = 1;
            const DistanceErrors errors = errorsOf(set, 37, 23, wrap);
            EXPECT_EQ(errors.tooLarge + errors.tooSmall, 0u) << place << wrapModeName(wrap);
        }
}

TEST(SequentialDistances, HaveTheErrorsThatTheMethodIsKnownFor) {
    const Set set = randomSet(160, 90, 400, 400);
    for (const WrapMode wrap : kWraps)
        EXPECT_GT(errorsOf(set, 160, 90, wrap).tooLarge, 0u) << wrapModeName(wrap);
}

TEST(SequentialDistances, AreUnlimitedWithoutASet) {
    for (const std::uint32_t distance :
         sequentialDistances(Set(15, 0), 5, 3, WrapMode::Repeat).texels)
        EXPECT_EQ(distance, SquaredDistances::kUnlimited);
}

TEST(SequentialDistances, AreCaughtWhenTheyForgetToRepeat) {
    const Set set = randomSet(37, 53, 400, 1);
    const DistanceErrors errors =
        compareDistances(sequentialDistances(set, 37, 53, WrapMode::Clamp),
                         distancesTo(set, 37, 53, WrapMode::Repeat));
    EXPECT_GT(errors.greatest, 1.0);
}

}  // namespace
}  // namespace relievo::preprocess
