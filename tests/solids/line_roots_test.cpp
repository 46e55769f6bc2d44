#include "solids/line_roots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solids/section_roots.h"

namespace relievo::solids {
namespace {

TEST(SignChanges, AreTheRootsOfQuadratics) {
    std::mt19937_64 random(20301);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int k = 0; k < 10000; ++k) {
        const double first = unit(random);
        const double second = first + std::pow(10.0, 6.0 * unit(random) - 6.0);
        const double scale = std::pow(10.0, 6.0 * unit(random));
        const SignChanges changes =
            signChanges({scale * first * second, -scale * (first + second), scale}, 1.5);
        const int expected =
            (first > 0.0 && first < 1.5 ? 1 : 0) + (second > 0.0 && second < 1.5 ? 1 : 0);
        // The coefficients are rounded: roots closer than √ε may be lost or shifted.
        if (second - first < 1e-6 || std::abs(first) < 1e-9 || std::abs(second) < 1e-9 ||
            std::abs(second - 1.5) < 1e-9)
            continue;
        ASSERT_EQ(changes.count, expected) << first << ' ' << second;
        for (int c = 0; c < changes.count; ++c) {
            const double s = changes.places[static_cast<std::size_t>(c)];
            EXPECT_LT(std::min(std::abs(s - first), std::abs(s - second)), 1e-8);
        }
    }
}

TEST(SignChanges, DegenerateQuadratics) {
    EXPECT_EQ(signChanges({0.0, 0.0, 0.0}, 1.0).count, 0);
    EXPECT_EQ(signChanges({1.0, 0.0, 0.0}, 1.0).count, 0);
    EXPECT_EQ(signChanges({0.25, -1.0, 1.0}, 1.0).count, 0);  // a touch
    EXPECT_EQ(signChanges({0.5, -1.0, 0.0}, 1.0).count, 1);
    EXPECT_EQ(signChanges({0.5, -1.0, 1e-300}, 1.0).count, 1);
    EXPECT_EQ(signChanges({0.0, -1.0, 2.0}, 1.0).count, 1);
    EXPECT_EQ(signChanges({-1.0, 1e-300, 1e-300}, INFINITY).count, 1);
    EXPECT_TRUE((Quadratic{0.0, 0.0, 0.0}.beginsInside()));
    EXPECT_TRUE((Quadratic{0.0, -1.0, 9.0}.beginsInside()));
    EXPECT_FALSE((Quadratic{0.0, 0.0, 1.0}.beginsInside()));
    EXPECT_FALSE((Quadratic{0.0, 1.0, -9.0}.beginsInside()));
}

// A cell of which the line is in the second column, going outwards.
SectionCell randomSection(std::mt19937_64& random, double extension) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    return {reference::BilinearCell(unit(random), unit(random), unit(random), unit(random)),
            RadialLine{1.2, 0.1, 1.0},
            1.0,
            1.0,
            0.5 + 0.5 * unit(random),
            unit(random),
            extension};
}

std::vector<double> changesOf(const SectionCell& section, double a, double b) {
    std::vector<double> places;
    appendSignChanges(section, a, b, places);
    return places;
}

TEST(SectionRoots, AreAllThatFineSamplesShow) {
    std::mt19937_64 random(20302);
    std::size_t roots = 0;
    for (int k = 0; k < 3000; ++k) {
        const SectionCell section = randomSection(random, 0.0);
        const std::vector<double> places = changesOf(section, 0.0, 1.5);
        roots += places.size();
        EXPECT_EQ(places.size() % 2 == 1, section.isInside(0.0) != section.isInside(1.5));
        bool isInside = section.isInside(0.0);
        std::size_t next = 0;
        for (int s = 1; s <= 2000; ++s) {
            const double t = 1.5 * s / 2000.0;
            while (next < places.size() && places[next] <= t) {
                isInside = !isInside;
                ++next;
            }
            if (std::abs(section.value(t)) > 1e-12) {
                ASSERT_EQ(section.isInside(t), isInside) << k << ' ' << t;
            }
        }
        for (const double t : places)
            EXPECT_LT(std::abs(section.value(t)), 1e-13);
    }
    EXPECT_GT(roots, 1000u);
}

TEST(SectionRoots, DipsOfABillionthAreFound) {
    // The least value along the line, moved to just below 0 and to just above it.
    std::mt19937_64 random(20303);
    int dips = 0;
    for (int k = 0; k < 3000; ++k) {
        SectionCell section = randomSection(random, 0.0);
        double best = 0.0;
        for (int s = 0; s <= 3000; ++s)
            if (section.value(1.5 * s / 3000.0) < section.value(best))
                best = 1.5 * s / 3000.0;
        if (best == 0.0 || best == 1.5)
            continue;
        double a = best - 5e-4;
        double b = best + 5e-4;
        for (int n = 0; n < 100; ++n)
            (section.derivative(0.5 * (a + b)) < 0.0 ? a : b) = 0.5 * (a + b);
        const double least = section.value(0.5 * (a + b));
        for (const double depth : {1e-9, 1e-12, 1e-14}) {
            section.extension = least + depth;
            EXPECT_EQ(changesOf(section, 0.0, 1.5).size(), 2u) << k << ' ' << depth;
            section.extension = least - depth;
            EXPECT_EQ(changesOf(section, 0.0, 1.5).size(), 0u) << k << ' ' << depth;
        }
        ++dips;
    }
    EXPECT_GT(dips, 100);
}

TEST(SectionRoots, FlatOnesTakeNoTime) {
    // The section is the line's own hyperbola: d is 0 along it, up to rounding.
    SectionCell section = {reference::BilinearCell(0.0, 0.0, 0.0, 0.0),
                           RadialLine{1.2, 0.1, 1.0},
                           1.0,
                           1.0,
                           0.3,
                           0.2,
                           0.0};
    EXPECT_TRUE(changesOf(section, 0.0, 1.5).empty());
    EXPECT_TRUE(section.isInside(0.5));
    section.cell = reference::BilinearCell(1e-17, -1e-17, -1e-17, 1e-17);
    EXPECT_LT(changesOf(section, 0.0, 1.5).size(), 4u);
    // A line through the axis, and one along it.
    section.line = {0.0, -1.0, 1.0};
    section.cell = reference::BilinearCell(-0.5, 0.5, -0.5, 0.5);
    section.firstColumn = 0.5;
    EXPECT_EQ(changesOf(section, 0.0, 0.5).size(), 0u);
    section.firstColumn = 0.0;
    EXPECT_EQ(changesOf(section, 0.0, 1.0).size(), 1u);
    section.line = {0.7, 0.0, 0.0};
    section.cell = reference::BilinearCell(-0.5, -0.5, 0.5, 0.5);
    EXPECT_EQ(changesOf(section, 0.0, 2.0).size(), 1u);
}

}  // namespace
}  // namespace relievo::solids
