// Creases at the corners of outlines: what they leave alone, how far they change distances, and
// that tiles fit together.
#include "preprocess/outline_creases.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <string>

#include "outline_error.h"
#include "preprocess/boundary_distance.h"
#include "preprocess/inside_mask.h"
#include "preprocess/plane_shape.h"
#include "reference/sample_outlines.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

struct Baked {
    PlaneShape shape;
    Plane distance;
    CreasedDistances creased;

    Baked(const outlines::Outline& outline, int size, WrapMode wrap)
        : shape(shapeOf(outline, size, size, wrap)),
          distance(
              measureBoundaryDistances(buildBoundaryTree(shape.boundary), size, size).distance) {
        const std::vector<std::uint8_t> mask = insideMask(shape, size, size);
        for (std::size_t k = 0; k < mask.size(); ++k)
            distance.texels[k] *= mask[k] != 0 ? -1.0f : 1.0f;
        creased = creaseCorners(shape.boundary, distance, wrap);
    }
};

outlines::Contour star(const glm::dvec2& centre, double radius, double turn) {
    outlines::Contour contour;
    for (int k = 0; k < 10; ++k) {
        const double angle = turn + std::numbers::pi * k / 5.0;
        contour.push_back(centre + (k % 2 == 0 ? radius : 0.4 * radius) *
                                       glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return contour;
}

TEST(OutlineCreases, SmoothOutlinesAndNoneStayAsTheyAre) {
    for (const WrapMode wrap : kWraps) {
        const Baked disc({{reference::circleContour({0.45, 0.52}, 0.3)}}, 61, wrap);
        EXPECT_EQ(disc.creased.distance.texels, disc.distance.texels);
        EXPECT_EQ(disc.creased.sharpCorners + disc.creased.roundCorners, 0);
        for (const float e : disc.creased.code.texels)
            EXPECT_EQ(e, 0.0f);
        EXPECT_EQ(Baked({}, 1, wrap).creased.sharpCorners, 0);
    }
}

// Outside of tips of 36° no sample gets nearer by more than √2·(1 − sin 18°), and none further
// away.
TEST(OutlineCreases, ChangeDistancesLittleAndToTheSafeSide) {
    const Baked baked({{star({0.51, 0.49}, 0.4, 0.3)}}, 128, WrapMode::Clamp);
    EXPECT_EQ(baked.creased.sharpCorners, 10);
    int changed = 0;
    for (std::size_t k = 0; k < baked.distance.texels.size(); ++k) {
        const double exact = baked.distance.texels[k];
        const double f = baked.creased.distance.texels[k];
        EXPECT_EQ(f > 0.0, exact > 0.0);
        EXPECT_LT(std::abs(f), std::abs(exact) + 1e-5);
        EXPECT_GT(std::abs(f), std::abs(exact) - std::sqrt(2.0));
        changed += std::abs(f - exact) > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(changed, 0);
    EXPECT_LT(changed, 200);
}

// A tile that begins elsewhere in the same repeated pattern has the same creased field, with
// corners on its border and across it.
TEST(OutlineCreases, RepeatedTilesFitTogether) {
    constexpr int kSize = 64;
    const auto shifted = [](int x, int y) {
        outlines::Outline outline;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
                outline.contours.push_back(
                    star(glm::dvec2(i + (33.25 + x) / kSize, j + (31.5 + y) / kSize), 0.45, 0.3));
        return Baked(outline, kSize, WrapMode::Repeat);
    };
    const Baked whole = shifted(0, 0);
    EXPECT_EQ(whole.creased.sharpCorners, 10);
    for (const glm::ivec2 shift : {glm::ivec2(32, 0), glm::ivec2(0, 29), glm::ivec2(13, 40)}) {
        const Baked cut = shifted(shift.x, shift.y);
        EXPECT_EQ(cut.creased.sharpCorners, 10);
        double largest = 0.0;
        for (int j = 0; j < kSize; ++j)
            for (int i = 0; i < kSize; ++i) {
                const std::size_t k = whole.distance.index(i, j);
                const std::size_t same =
                    cut.distance.index((i + shift.x) % kSize, (j + shift.y) % kSize);
                largest = std::max<double>(largest, std::abs(whole.creased.code.texels[k] -
                                                             cut.creased.code.texels[same]));
                largest = std::max<double>(largest, std::abs(whole.creased.distance.texels[k] -
                                                             cut.creased.distance.texels[same]));
            }
        EXPECT_LT(largest, 1e-4);
    }
}

// The way between two texels of a tile, or to the nearest copy.
double wayBetween(const glm::ivec2& a, const glm::ivec2& b, int size, WrapMode wrap) {
    glm::ivec2 way = glm::abs(a - b);
    if (wrap == WrapMode::Repeat)
        way = glm::min(way, size - way);
    return std::hypot(way.x, way.y);
}

// By how much s of any two samples differs more than they are apart, at most.
double steepestExcess(const Plane& s, WrapMode wrap) {
    double excess = 0.0;
    for (int k = 0; k < s.width * s.height; ++k)
        for (int l = 0; l < k; ++l) {
            const glm::ivec2 a(k % s.width, k / s.width);
            const glm::ivec2 b(l % s.width, l / s.width);
            const double rise = std::abs(static_cast<double>(s.at(a.x, a.y)) - s.at(b.x, b.y));
            excess = std::max(excess, rise - wayBetween(a, b, s.width, wrap));
        }
    return excess;
}

// What steps are safe by, with convex and reflex corners and tips, across borders too. f itself is
// steeper: the check sees it.
TEST(OutlineCreases, StepDistancesAreNowhereSteeperThanDistances) {
    constexpr int kSize = 72;
    for (const WrapMode wrap : kWraps) {
        const Baked baked({{star({0.51, 0.62}, 0.45, 0.3)}}, kSize, wrap);
        EXPECT_GT(baked.creased.sharpCorners, 5);
        EXPECT_LT(steepestExcess(baked.creased.step, wrap), 2e-3);
        for (std::size_t k = 0; k < baked.distance.texels.size(); ++k)
            EXPECT_LE(baked.creased.step.texels[k], baked.distance.texels[k] + 1e-6);
    }
    const Baked baked({{star({0.51, 0.49}, 0.4, 0.3)}}, kSize, WrapMode::Clamp);
    EXPECT_GT(steepestExcess(baked.creased.distance, WrapMode::Clamp), 0.1);
}

Plane noLessThan(Plane plane, double least) {
    for (float& texel : plane.texels)
        texel = std::max(texel, static_cast<float>(least));
    return plane;
}

// From offsets of kCornersEndTexels on steps may go by distances: what corners change lies a
// diagonal deeper, and lower limits would leave some of it.
TEST(OutlineCreases, EndAtTheOffsetFromWhichOnDistancesAreSafe) {
    constexpr int kSize = 72;
    const double deepest = textures::kCornersEndTexels - std::sqrt(2.0);
    for (const WrapMode wrap : kWraps) {
        const Baked baked({{star({0.51, 0.62}, 0.45, 0.3)}}, kSize, wrap);
        EXPECT_LT(steepestExcess(noLessThan(baked.creased.distance, deepest), wrap), 2e-3);
        for (std::size_t k = 0; k < baked.distance.texels.size(); ++k) {
            const double c = std::abs(baked.creased.code.texels[k]);
            const bool isConvex = c > 0.0 && c < textures::kLeastReflexTexels;
            EXPECT_TRUE(!isConvex || baked.creased.distance.texels[k] <= deepest);
            const bool isChanged = baked.creased.distance.texels[k] != baked.distance.texels[k];
            EXPECT_TRUE(!isChanged || baked.distance.texels[k] <= deepest);
        }
        EXPECT_GT(steepestExcess(noLessThan(baked.creased.distance, 0.0), wrap), 0.05);
    }
}

// Convex and reflex corners in turn, `side` texels from each other.
outlines::Contour stairs(double side) {
    outlines::Contour contour{{6.1, 60.2}};
    for (int k = 0; k < 6; ++k) {
        const glm::dvec2 from(6.1 + side * k, 60.2 - 1.01 * side * (k + 1));
        contour.push_back(from);
        contour.emplace_back(from.x + side, from.y);
    }
    contour.emplace_back(contour.back().x, 60.2);
    return contour;
}

struct StairErrors {
    double plain;
    double creased;
    int round;
};

StairErrors errorsOfStairs(double side) {
    constexpr int kSize = 64;
    const outlines::Contour contour = stairs(side);
    outlines::Contour inTiles = contour;
    for (glm::dvec2& point : inTiles)
        point /= static_cast<double>(kSize);
    const Baked baked({{inTiles}}, kSize, WrapMode::Clamp);
    const reference::PlaneOutline outline({contour});
    const auto largest = [&](const SampledDistance& field) {
        const OutlineErrors errors =
            measureErrors(field, {contour}, outline, glm::ivec2(1), glm::ivec2(kSize - 1));
        return std::max(errors.away(), errors.atCorners());
    };
    return {largest({baked.distance, {}}), largest({baked.creased.distance, baked.creased.code}),
            baked.creased.roundCorners};
}

TEST(OutlineCreases, NeighbouringCornersAreSharpOrLeftAlone) {
    for (const double side : {1.3, 2.2, 3.1, 4.4, 5.3, 7.7, 8.3}) {
        const StairErrors errors = errorsOfStairs(side);
        fmt::print("sides of {}: plain {:.3f}, creased {:.3f}, round corners {}\n", side,
                   errors.plain, errors.creased, errors.round);
        EXPECT_LE(errors.creased, errors.plain + 0.01);
        if (side > 6.0) {
            EXPECT_EQ(errors.round, 0);
            EXPECT_LT(errors.creased, 0.05);
        }
    }
}

// What is wrong on purpose must be found out: a boundary that goes around the other way.
TEST(OutlineCreases, ReversedBoundariesHaveNoSharpCorners) {
    const Baked baked({{star({0.51, 0.49}, 0.4, 0.3)}}, 128, WrapMode::Clamp);
    std::vector<BoundarySegment> reversed(baked.shape.boundary.rbegin(),
                                          baked.shape.boundary.rend());
    for (BoundarySegment& segment : reversed)
        std::swap(segment.start, segment.end);
    const CreasedDistances creased = creaseCorners(reversed, baked.distance, WrapMode::Clamp);
    EXPECT_EQ(creased.sharpCorners, 0);
    EXPECT_EQ(creased.distance.texels, baked.distance.texels);
}

}  // namespace
}  // namespace relievo::preprocess
