// Second moments of slopes against brute force: slopes interpolated between the texels, sampled
// finely.
#include "materials/slope_moments.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "tests/textures/random_planes.h"

namespace relievo::materials {
namespace {

using textures::DepthMap;
using textures::WrapMode;

struct Moments {
    double xx = 0.0, xy = 0.0, yy = 0.0;
};

DepthMap randomRelief(int width, int height, WrapMode wrap) {
    return {textures::randomPlane(width, height, 0.0f, 1.0f, 5), wrap};
}

// Central differences at texel (i,j), which may lie beyond the tile; per tile width.
std::array<double, 2> slopeOfTexel(const DepthMap& map, int i, int j) {
    const double scale = 0.5 * map.width();
    return {scale * (static_cast<double>(map.at(i + 1, j)) - map.at(i - 1, j)),
            scale * (static_cast<double>(map.at(i, j + 1)) - map.at(i, j - 1))};
}

// x and y in texels, 0 at the centre of the first.
std::array<double, 2> slopeBetween(const DepthMap& map, double x, double y) {
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    std::array<double, 2> slope{};
    for (const int down : {0, 1})
        for (const int across : {0, 1}) {
            const double share = (across ? x - i : 1.0 - (x - i)) * (down ? y - j : 1.0 - (y - j));
            const auto texel = slopeOfTexel(map, i + across, j + down);
            slope[0] += share * texel[0];
            slope[1] += share * texel[1];
        }
    return slope;
}

// Over the texels [left, right) × [top, bottom) of the map.
Moments bruteForce(const DepthMap& map, int left, int top, int right, int bottom) {
    constexpr int kSamples = 32;  // of a texel along each axis
    Moments sum;
    for (int n = 0; n < (bottom - top) * kSamples; ++n)
        for (int m = 0; m < (right - left) * kSamples; ++m) {
            const auto [x, y] = slopeBetween(map, left - 0.5 + (m + 0.5) / kSamples,
                                             top - 0.5 + (n + 0.5) / kSamples);
            sum.xx += x * x;
            sum.xy += x * y;
            sum.yy += y * y;
        }
    const double count = 1.0 * kSamples * kSamples * (right - left) * (bottom - top);
    return {sum.xx / count, sum.xy / count, sum.yy / count};
}

double meanOf(const textures::Plane& plane) {
    return std::accumulate(plane.texels.begin(), plane.texels.end(), 0.0) /
           static_cast<double>(plane.texels.size());
}

void expectMoments(double xx, double xy, double yy, const Moments& truth) {
    const double tolerance = 1e-3 * (truth.xx + truth.yy);
    EXPECT_NEAR(xx, truth.xx, tolerance);
    EXPECT_NEAR(xy, truth.xy, tolerance);
    EXPECT_NEAR(yy, truth.yy, tolerance);
}

TEST(SlopeMoments, AreThoseOfTheInterpolatedSlopesTexelByTexel) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp}) {
        const DepthMap map = randomRelief(8, 4, wrap);
        const std::vector<SlopeMoments> levels = slopeMoments(map);
        ASSERT_EQ(levels.size(), 3u);
        const SlopeMoments& level = levels.front();
        ASSERT_EQ(level.xx.width, 4);
        ASSERT_EQ(level.xx.height, 2);
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 4; ++i) {
                SCOPED_TRACE(testing::Message() << wrapModeName(wrap) << " " << i << "," << j);
                expectMoments(level.xx.at(i, j), level.xy.at(i, j), level.yy.at(i, j),
                              bruteForce(map, 2 * i, 2 * j, 2 * i + 2, 2 * j + 2));
            }
    }
}

// Whatever the size, no level loses any.
TEST(SlopeMoments, HaveTheSameMeanInEveryLevel) {
    for (const auto& [width, height] :
         {std::array{13, 7}, std::array{1, 16}, std::array{5, 1}, std::array{32, 2}}) {
        const DepthMap map = randomRelief(width, height, WrapMode::Mirror);
        const Moments truth = bruteForce(map, 0, 0, width, height);
        for (const SlopeMoments& level : slopeMoments(map))
            expectMoments(meanOf(level.xx), meanOf(level.xy), meanOf(level.yy), truth);
    }
    EXPECT_TRUE(slopeMoments(randomRelief(1, 1, WrapMode::Repeat)).empty());
}

// The wrong variant, squares of the texels' own slopes, is too much by far for what shading sees.
TEST(SlopeMoments, AreNotThoseOfTheTexels) {
    const DepthMap map = randomRelief(16, 16, WrapMode::Repeat);
    double squares = 0.0;
    for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 16; ++i)
            squares += slopeOfTexel(map, i, j)[0] * slopeOfTexel(map, i, j)[0] / 256.0;
    EXPECT_GT(squares, 1.5 * bruteForce(map, 0, 0, 16, 16).xx);
}

}  // namespace
}  // namespace relievo::materials
