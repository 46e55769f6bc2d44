#include "reference/bilinear_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace relievo::reference {
namespace {

TEST(BilinearCell, ReturnsItsCornersAndItsMinimum) {
    const BilinearCell cell(0.25, 0.5, 0.75, 0.125);
    EXPECT_EQ(cell.depth({0, 0}), 0.25);
    EXPECT_EQ(cell.depth({1, 0}), 0.5);
    EXPECT_EQ(cell.depth({0, 1}), 0.75);
    EXPECT_EQ(cell.depth({1, 1}), 0.125);
    EXPECT_EQ(cell.minimum, 0.125);
}

TEST(BilinearCell, LineRestrictionIsTheCellAlongTheLine) {
    const BilinearCell cell(0.3, 0.7, 0.1, 0.9);
    const glm::dvec3 from(0.2, 0.4, 0.05);
    const glm::dvec3 direction(0.5, -0.25, 0.1);
    const DepthBelowSurface below = depthBelowSurface(cell, from, direction);
    for (double s = 0.0; s < 1.0; s += 0.125) {
        const glm::dvec3 p = from + s * direction;
        EXPECT_NEAR(below.constant + s * (below.linear + s * below.quadratic),
                    p.z - cell.depth(glm::dvec2(p)), 1e-15);
    }
}

TEST(FirstCrossing, SpecialForms) {
    EXPECT_EQ(firstCrossing({0.0, 1.0, 1.0}), 0.0);
    EXPECT_EQ(firstCrossing({0.5, -1.0, 0.0}), 0.0);
    EXPECT_EQ(firstCrossing({-1.0, 2.0, 0.0}), 0.5);
    EXPECT_EQ(firstCrossing({-1.0, 0.0, 4.0}), 0.5);
    EXPECT_EQ(firstCrossing({-1.0, 0.0, 0.0}), std::nullopt);
    EXPECT_EQ(firstCrossing({-1.0, -2.0, 0.0}), std::nullopt);
    EXPECT_EQ(firstCrossing({-1.0, -2.0, -1.0}), std::nullopt);
    EXPECT_EQ(firstCrossing({-1.0, 1.0, -1.0}), std::nullopt);
    EXPECT_EQ(firstCrossing({-1.0, 2.0, -1.0}), 1.0);  // touches
    EXPECT_EQ(firstCrossing({-2.0, 3.0, -1.0}), 1.0);  // the first of two
    EXPECT_EQ(firstCrossing({-2.0, -1.0, 1.0}), 2.0);  // the positive of two
}

TEST(FirstCrossing, KeepsItsDigitsWhereTheTextbookFormLosesThem) {
    // Roots r and R of opposite sign, or both positive, nine orders of magnitude apart.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> factor(1.0, 2.0);
    double worst = 0.0;
    double worstTextbook = 0.0;
    for (int k = 0; k < 1000; ++k) {
        const double r = factor(random);
        const double R = 1e9 * factor(random) * (k % 2 == 0 ? 1.0 : -1.0);
        // ±(s − r)(s − R), with the sign that makes it negative at 0.
        const double sign = R > 0.0 ? -1.0 : 1.0;
        const double q0 = sign * r * R;
        const double q1 = -sign * (r + R);
        const auto s = firstCrossing({q0, q1, sign});
        ASSERT_TRUE(s);
        worst = std::max(worst, std::abs(*s - r));
        const double root = std::sqrt(q1 * q1 - 4.0 * sign * q0);
        worstTextbook = std::max(worstTextbook, std::abs((root - q1) / (2.0 * sign) - r));
    }
    EXPECT_LT(worst, 1e-14);
    EXPECT_GT(worstTextbook, 1e-9);
}

TEST(FirstCrossing, TellsRootsApartThatAlmostCoincide) {
    // −(s − 1)(s − R), with coefficients that are exact; 4·q0·q2 and q1² agree in all their digits.
    const double R = 1.0 + std::ldexp(1.0, -27);
    const auto s = firstCrossing({-R, 1.0 + R, -1.0});
    ASSERT_TRUE(s);
    EXPECT_NEAR(*s, 1.0, 1e-15);
}

}  // namespace
}  // namespace relievo::reference
