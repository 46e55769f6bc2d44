// Signed distances, insides and crossings of outlines against closed forms and brute force.
#include "reference/plane_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "reference/sample_outlines.h"

namespace relievo::reference {
namespace {

using Places = std::uniform_real_distribution<double>;

double distanceTo(const glm::dvec2& place, const glm::dvec2& start, const glm::dvec2& end) {
    const glm::dvec2 along = end - start;
    const double share =
        std::clamp(glm::dot(place - start, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::distance(place, start + share * along);
}

// Even-odd by a line to the right, written down another way than in the tested code.
bool isInsideByParity(const std::vector<OutlineContour>& contours, const glm::dvec2& place) {
    bool isInside = false;
    for (const OutlineContour& contour : contours)
        for (std::size_t k = 0; k < contour.size(); ++k) {
            const glm::dvec2& a = contour[k];
            const glm::dvec2& b = contour[(k + 1) % contour.size()];
            if ((a.y > place.y) != (b.y > place.y) &&
                place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y))
                isInside = !isInside;
        }
    return isInside;
}

double bruteDistance(const std::vector<OutlineContour>& contours, const glm::dvec2& place) {
    double nearest = HUGE_VAL;
    for (const OutlineContour& contour : contours)
        for (std::size_t k = 0; k < contour.size(); ++k)
            nearest =
                std::min(nearest, distanceTo(place, contour[k], contour[(k + 1) % contour.size()]));
    return isInsideByParity(contours, place) ? -nearest : nearest;
}

TEST(PlaneOutline, DistancesAreThoseOfAllSegments) {
    std::mt19937 random(1);
    Places place(-0.5, 1.5);
    for (const std::string name : {"star", "comb"}) {
        const std::vector<SampleOutline> shapes = sampleShapes();
        const auto& shape = *std::find_if(shapes.begin(), shapes.end(),
                                          [&](const auto& one) { return one.name == name; });
        const PlaneOutline outline(shape.contours, shape.filling);
        for (int k = 0; k < 3000; ++k) {
            const glm::dvec2 where(place(random), place(random));
            const NearestOutlinePoint found = outline.nearest(where);
            ASSERT_NEAR(found.distance, bruteDistance(shape.contours, where), 1e-14);
            EXPECT_NEAR(glm::length(found.direction), 1.0, 1e-12);
            // Back along the direction there is the outline.
            EXPECT_NEAR(glm::distance(where - found.distance * found.direction, found.point), 0.0,
                        1e-14);
        }
    }
}

TEST(PlaneOutline, ADiscIsACircle) {
    const glm::dvec2 centre(0.4, 0.6);
    const PlaneOutline disc({circleContour(centre, 0.3)});
    std::mt19937 random(2);
    Places place(0.0, 1.0);
    for (int k = 0; k < 5000; ++k) {
        const glm::dvec2 where(place(random), place(random));
        const double exact = glm::distance(where, centre) - 0.3;
        EXPECT_NEAR(disc.distance(where), exact, kSampleTolerance);
    }
}

// A hole is one in either filling when contours go around in opposite directions, and only in
// even-odd when they go around in the same one.
TEST(PlaneOutline, FillingsDifferWhereContoursGoAroundAlike) {
    const OutlineContour outer{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}};
    const OutlineContour inner{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
    const OutlineContour reversed(inner.rbegin(), inner.rend());
    const glm::dvec2 middle(0.5);
    EXPECT_FALSE(PlaneOutline({outer, inner}, Filling::EvenOdd).isInside(middle));
    EXPECT_TRUE(PlaneOutline({outer, inner}, Filling::NonZero).isInside(middle));
    EXPECT_FALSE(PlaneOutline({outer, reversed}, Filling::NonZero).isInside(middle));
    EXPECT_NEAR(PlaneOutline({outer, reversed}).distance(middle), 0.2, 1e-15);
}

TEST(PlaneOutline, NothingIsInsideOfNothing) {
    const PlaneOutline empty({{}, {{0.5, 0.5}}});
    EXPECT_FALSE(empty.isInside({0.5, 0.5}));
    EXPECT_EQ(empty.distance({0.5, 0.5}), HUGE_VAL);
    EXPECT_FALSE(empty.firstCrossing({0.0, 0.0}, {1.0, 1.0}, 0.0, 10.0).has_value());
}

TEST(PlaneOutline, CrossingsChangeTheInside) {
    const std::vector<SampleOutline> shapes = sampleShapes();
    std::mt19937 random(3);
    Places place(-0.2, 1.2);
    for (const SampleOutline& shape : shapes) {
        SCOPED_TRACE(shape.name);
        const PlaneOutline outline(shape.contours, shape.filling);
        for (int k = 0; k < 1000; ++k) {
            const glm::dvec2 origin(place(random), place(random));
            const glm::dvec2 direction(place(random) - 0.5, place(random) - 0.5);
            const auto crossing = outline.firstCrossing(origin, direction, 0.0, 5.0);
            const double end = crossing ? crossing->t : 5.0;
            for (const double share : {0.001, 0.25, 0.6, 0.999})
                EXPECT_EQ(outline.isInside(origin + share * end * direction),
                          outline.isInside(origin));
            if (!crossing)
                continue;
            EXPECT_NEAR(outline.distance(origin + end * direction), 0.0, 1e-14);
            EXPECT_LE(glm::dot(crossing->normal, direction), 0.0);
        }
    }
}

// Rays at the corners themselves: to one side or the other of the corner, but not through it.
TEST(PlaneOutline, RaysDoNotSlipThroughCorners) {
    const OutlineContour star = sampleShapes()[2].contours[0];
    const PlaneOutline outline({star});
    const glm::dvec2 centre(0.5013, 0.4987);
    for (const glm::dvec2& corner : star) {
        const glm::dvec2 direction = corner - centre;
        EXPECT_TRUE(outline.firstCrossing(centre, direction, 0.0, 2.0).has_value());
    }
}

}  // namespace
}  // namespace relievo::reference
