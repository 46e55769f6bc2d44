#include "textures/bilinear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "random_planes.h"

namespace relievo::textures {
namespace {

constexpr std::array kModes{WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

/// Every texel of the neighbourhood weighted by a tent over its centre: the definition of bilinear
/// interpolation, without any choice of cells.
double tentSum(const Plane& plane, double u, double v, WrapMode wrap) {
    const double x = u * plane.width, y = v * plane.height;
    double sum = 0.0;
    for (int j = static_cast<int>(std::floor(y)) - 2; j <= std::floor(y) + 2; ++j)
        for (int i = static_cast<int>(std::floor(x)) - 2; i <= std::floor(x) + 2; ++i)
            sum += std::max(0.0, 1.0 - std::abs(x - i - 0.5)) *
                   std::max(0.0, 1.0 - std::abs(y - j - 0.5)) *
                   plane.at(wrapIndex(i, plane.width, wrap), wrapIndex(j, plane.height, wrap));
    return sum;
}

/// The mistake of putting texel (0,0) at (0,0) instead of its centre at half a texel.
double withoutHalfTexel(const Plane& plane, double u, double v, WrapMode wrap) {
    return sampleBilinear(plane, u + 0.5 / plane.width, v + 0.5 / plane.height, wrap);
}

template <class Sample>
double largestError(Sample sample) {
    double largest = 0.0;
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> coordinate(-2.5, 3.5);
    for (const auto& [width, height] : {std::array{1, 1}, std::array{1, 5}, std::array{7, 3},
                                        std::array{13, 31}, std::array{16, 16}}) {
        const Plane plane = randomPlane(width, height, 0.0f, 1.0f, 9);
        for (const WrapMode wrap : kModes)
            for (int n = 0; n < 500; ++n) {
                const double u = coordinate(generator), v = coordinate(generator);
                largest = std::max(
                    largest, std::abs(sample(plane, u, v, wrap) - tentSum(plane, u, v, wrap)));
            }
    }
    return largest;
}

TEST(Bilinear, IsTheSumOfTents) {
    EXPECT_LT(largestError(sampleBilinear), 1e-12);
    EXPECT_GT(largestError(withoutHalfTexel), 0.1) << "the check must see a shift of half a texel";
}

TEST(Bilinear, GivesTheTexelsAtTheirCentres) {
    const Plane plane = randomPlane(11, 6, -3.0f, 3.0f, 2);
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 11; ++i) {
            const double u = (i + 0.5) / 11.0, v = (j + 0.5) / 6.0;
            EXPECT_NEAR(sampleBilinear(plane, u, v, WrapMode::Clamp), plane.at(i, j), 1e-12);
            EXPECT_EQ(sampleNearest(plane, u, v, WrapMode::Clamp), plane.at(i, j));
        }
}

TEST(Bilinear, StaysWithinTheSamples) {
    const Plane flat(5, 4, 0.7f);
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> coordinate(-1e5, 1e5);
    for (int n = 0; n < 1000; ++n)
        EXPECT_EQ(
            sampleBilinear(flat, coordinate(generator), coordinate(generator), WrapMode::Mirror),
            0.7f);
}

TEST(Nearest, TakesTheTexelThatHoldsThePoint) {
    const Plane plane = randomPlane(4, 4, 0.0f, 1.0f, 3);
    EXPECT_EQ(sampleNearest(plane, 0.26, 0.99, WrapMode::Repeat), plane.at(1, 3));
    EXPECT_EQ(sampleNearest(plane, -0.01, 1.01, WrapMode::Repeat), plane.at(3, 0));
    EXPECT_EQ(sampleNearest(plane, -0.01, 1.01, WrapMode::Mirror), plane.at(0, 3));
    EXPECT_EQ(sampleNearest(plane, -9.0, 9.0, WrapMode::Clamp), plane.at(0, 3));
}

}  // namespace
}  // namespace relievo::textures
