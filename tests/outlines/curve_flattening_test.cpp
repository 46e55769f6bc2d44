// Polylines stay within the tolerance of the curves that they stand for, and are no finer than they
// must be.
#include "outlines/curve_flattening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace relievo::outlines {
namespace {

glm::dvec2 cubicAt(const std::array<glm::dvec2, 4>& p, double t) {
    const double s = 1.0 - t;
    return s * s * s * p[0] + 3.0 * s * s * t * p[1] + 3.0 * s * t * t * p[2] + t * t * t * p[3];
}

double distanceTo(const Contour& polyline, const glm::dvec2& place) {
    double nearest = HUGE_VAL;
    for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
        const glm::dvec2 along = polyline[k + 1] - polyline[k];
        const double square = glm::dot(along, along);
        const double share =
            square > 0.0 ? std::clamp(glm::dot(place - polyline[k], along) / square, 0.0, 1.0)
                         : 0.0;
        nearest = std::min(nearest, glm::distance(place, polyline[k] + share * along));
    }
    return nearest;
}

double worstDistance(const std::array<glm::dvec2, 4>& points, const Contour& polyline) {
    double worst = 0.0;
    for (int k = 0; k <= 500; ++k)
        worst = std::max(worst, distanceTo(polyline, cubicAt(points, k / 500.0)));
    return worst;
}

TEST(CurveFlattening, StaysWithinTheTolerance) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    for (const double tolerance : {1e-1, 1e-3, 1e-5})
        for (int k = 0; k < 40; ++k) {
            std::array<glm::dvec2, 4> points;
            for (glm::dvec2& point : points)
                point = {place(random), place(random)};
            Contour polyline{points[0]};
            appendCubic(points, tolerance, polyline);
            EXPECT_EQ(polyline.back(), points[3]);
            EXPECT_LE(worstDistance(points, polyline), tolerance);
        }
}

// With a third of the chords the same curves leave the tolerance.
TEST(CurveFlattening, IsNotMuchFinerThanItMustBe) {
    const std::array<glm::dvec2, 4> points{glm::dvec2(0, 0), glm::dvec2(0, 1), glm::dvec2(1, 1),
                                           glm::dvec2(1, 0)};
    constexpr double kTolerance = 1e-4;
    Contour polyline{points[0]};
    appendCubic(points, kTolerance, polyline);
    Contour coarse;
    for (std::size_t k = 0; k < polyline.size(); k += 3)
        coarse.push_back(polyline[k]);
    coarse.push_back(points[3]);
    EXPECT_GT(worstDistance(points, coarse), kTolerance);
}

TEST(CurveFlattening, StraightAndEmptyCurvesAreOneChord) {
    Contour polyline{{0, 0}};
    appendCubic({glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(2, 2), glm::dvec2(3, 3)}, 1e-9,
                polyline);
    EXPECT_EQ(polyline.size(), 2u);
    appendQuadratic({glm::dvec2(3, 3), glm::dvec2(3, 3), glm::dvec2(3, 3)}, 1e-9, polyline);
    EXPECT_EQ(polyline.size(), 3u);
}

}  // namespace
}  // namespace relievo::outlines
