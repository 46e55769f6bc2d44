// Shapes on repeated, mirrored and clamped tiles: what is inside, and what is a boundary.
#include "preprocess/plane_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "preprocess/inside_mask.h"

namespace relievo::preprocess {
namespace {

using outlines::Contour;
using outlines::FillRule;
using outlines::Outline;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

Contour rectangle(double left, double top, double right, double bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

int insideCount(const Outline& outline, int width, int height, WrapMode wrap) {
    const std::vector<std::uint8_t> mask =
        insideMask(shapeOf(outline, width, height, wrap), width, height);
    return std::accumulate(mask.begin(), mask.end(), 0);
}

// Length of a boundary of level and upright segments within the tile, its right and lower side not
// included.
double boundaryLength(const PlaneShape& shape, int width, int height) {
    const glm::dvec2 size(width, height);
    double length = 0.0;
    for (const BoundarySegment& segment : shape.boundary) {
        const int along = segment.start.y == segment.end.y ? 0 : 1;
        const double place = segment.start[1 - along];
        if (place >= 0.0 && place < size[1 - along])
            length += std::abs(std::clamp(segment.start[along], 0.0, size[along]) -
                               std::clamp(segment.end[along], 0.0, size[along]));
    }
    return length;
}

TEST(PlaneShape, CountsTexelCentres) {
    const Outline outline{{rectangle(0.125, 0.25, 0.625, 0.75)}};
    for (const WrapMode wrap : kWraps) {
        EXPECT_EQ(insideCount(outline, 16, 16, wrap), 8 * 8);
        EXPECT_EQ(insideCount(outline, 16, 8, wrap), 8 * 4);
        EXPECT_NEAR(boundaryLength(shapeOf(outline, 16, 16, wrap), 16, 16), 4 * 8.0, 1e-6);
    }
}

// A stripe over the whole width has no ends, whatever comes after the tile.
TEST(PlaneShape, TheBorderOfTheTileIsNoBoundaryWhereTheShapeGoesOn) {
    const Outline stripe{{rectangle(-1.0, 0.25, 2.0, 0.5)}};
    for (const WrapMode wrap : kWraps)
        EXPECT_NEAR(boundaryLength(shapeOf(stripe, 32, 32, wrap), 32, 32), 2 * 32.0, 1e-6);
}

// Half a stripe ends at the border when the tile repeats, and not when it is mirrored or clamped.
TEST(PlaneShape, TheBorderIsABoundaryWhereTheNextTileIsOutside) {
    const Outline half{{rectangle(0.5, 0.25, 1.0, 0.5)}};
    const auto length = [&](WrapMode wrap) {
        return boundaryLength(shapeOf(half, 32, 32, wrap), 32, 32);
    };
    // Its own left end; and at the left border that of the tile before.
    EXPECT_NEAR(length(WrapMode::Repeat), 2 * 16.0 + 2 * 8.0, 1e-6);
    EXPECT_NEAR(length(WrapMode::Mirror), 2 * 16.0 + 8.0, 1e-6);
    EXPECT_NEAR(length(WrapMode::Clamp), 2 * 16.0 + 8.0, 1e-6);
}

TEST(PlaneShape, OverlapsHaveNoBoundaryInside) {
    const Outline cross{{rectangle(0.4, 0.1, 0.6, 0.9), rectangle(0.1, 0.4, 0.9, 0.6)}};
    const PlaneShape shape = shapeOf(cross, 100, 100, WrapMode::Clamp);
    EXPECT_NEAR(boundaryLength(shape, 100, 100), 4 * 80.0, 1e-4);
    const Outline holes{cross.contours, FillRule::EvenOdd};
    EXPECT_EQ(insideCount(cross, 100, 100, WrapMode::Clamp), 2 * 20 * 80 - 400);
    EXPECT_EQ(insideCount(holes, 100, 100, WrapMode::Clamp), 2 * 20 * 80 - 800);
}

// A figure of eight goes around its halves in opposite directions: both are inside.
TEST(PlaneShape, SelfIntersectionsFollowTheFillRule) {
    const Outline eight{{{{0.1, 0.1}, {0.9, 0.9}, {0.9, 0.1}, {0.1, 0.9}}}};
    const int inside = insideCount(eight, 100, 100, WrapMode::Clamp);
    EXPECT_NEAR(inside, 0.5 * 80 * 80, 90);
}

TEST(PlaneShape, EmptyAndFullShapesHaveNoBoundary) {
    for (const WrapMode wrap : kWraps) {
        const PlaneShape empty = shapeOf(Outline{}, 8, 8, wrap);
        EXPECT_TRUE(empty.boundary.empty());
        EXPECT_EQ(insideCount(Outline{}, 8, 8, wrap), 0);
        const Outline full{{rectangle(-1.0, -1.0, 2.0, 2.0)}};
        EXPECT_TRUE(shapeOf(full, 8, 8, wrap).boundary.empty());
        EXPECT_EQ(insideCount(full, 8, 8, wrap), 64);
    }
}

}  // namespace
}  // namespace relievo::preprocess
