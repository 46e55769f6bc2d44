// How far the zero level of baked distances is from the true outline, at 512²: analytic shapes and
// letters, from vector outlines and from anti-aliased bitmaps, away from corners and at them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "exact_coverage.h"
#include "outline_error.h"
#include "outlines/text_outline.h"
#include "preprocess/boundary_distance.h"
#include "preprocess/boundary_tree.h"
#include "preprocess/inside_mask.h"
#include "preprocess/outline_creases.h"
#include "preprocess/plane_shape.h"
#include "preprocess/shape_baker.h"
#include "reference/sample_outlines.h"

namespace relievo::preprocess {
namespace {

using reference::OutlineContour;
using reference::PlaneOutline;
using reference::SampleOutline;

constexpr int kSize = 512;
constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf";

SampleOutline letters(const std::string& text) {
    // Text is as high as its margin makes it: the tile is the text's width.
    const outlines::Drawing drawing =
        outlines::readTextDrawing(kFont, text, reference::kSampleTolerance);
    SampleOutline shape{"letters", {}, reference::Filling::NonZero};
    for (const outlines::Outline& outline : drawing.shapes)
        shape.contours.insert(shape.contours.end(), outline.contours.begin(),
                              outline.contours.end());
    return shape;
}

SampleOutline sample(const std::string& name) {
    for (const SampleOutline& one : reference::sampleShapes())
        if (one.name == name)
            return one;
    return letters(name);
}

std::vector<OutlineContour> inTexels(std::vector<OutlineContour> contours) {
    for (OutlineContour& contour : contours)
        for (glm::dvec2& point : contour)
            point *= static_cast<double>(kSize);
    return contours;
}

outlines::Outline outlineOf(const SampleOutline& shape) {
    return {shape.contours, shape.filling == reference::Filling::NonZero
                                ? outlines::FillRule::NonZero
                                : outlines::FillRule::EvenOdd};
}

textures::Plane signedDistances(const PlaneShape& shape) {
    textures::Plane plane =
        measureBoundaryDistances(buildBoundaryTree(shape.boundary), kSize, kSize).distance;
    const std::vector<std::uint8_t> mask = insideMask(shape, kSize, kSize);
    for (std::size_t k = 0; k < mask.size(); ++k)
        if (mask[k] != 0)
            plane.texels[k] = -plane.texels[k];
    return plane;
}

SampledDistance sampled(const CreasedDistances& creased) {
    return {creased.distance, creased.code};
}

textures::Plane inTexels(textures::Plane plane) {
    for (float& texel : plane.texels)
        texel *= static_cast<float>(kSize);
    return plane;
}

// What relievo-bake shape makes of a drawing, or of what is white in a bitmap of 8 bits, in texels.
SampledDistance bakedOf(const ShapeSource& source) {
    ShapePlan plan;
    plan.wrap = textures::WrapMode::Clamp;
    plan.isWhiteInside = std::holds_alternative<textures::Plane>(source.content);
    const textures::ShapeMap map = bakeShape(source, plan);
    return {inTexels(map.distance), inTexels(map.creases.code)};
}

struct Case {
    SampleOutline shape;
    std::vector<OutlineContour> contours;  // in texels
    PlaneOutline outline;
    PlaneShape plane;
    textures::Plane distance;

    explicit Case(const std::string& name)
        : shape(sample(name)),
          contours(inTexels(shape.contours)),
          outline(contours, shape.filling),
          plane(shapeOf(outlineOf(shape), kSize, kSize, textures::WrapMode::Clamp)),
          distance(signedDistances(plane)) {}

    [[nodiscard]] OutlineErrors errors(const SampledDistance& field) const {
        return measureErrors(field, contours, outline, glm::ivec2(1), glm::ivec2(kSize - 1), 8);
    }
    [[nodiscard]] SampledDistance plain() const { return {distance, {}}; }
    [[nodiscard]] CreasedDistances creased() const {
        return creaseCorners(plane.boundary, distance, textures::WrapMode::Clamp);
    }
    [[nodiscard]] textures::Plane coverage() const { return coverageOf(plane, kSize, kSize, 255); }
};

void print(const std::string& name, const std::string& what, const OutlineErrors& errors) {
    const auto line = [](const ErrorSummary& level, const ErrorSummary& outline) {
        return fmt::format("largest {:.4f} mean {:.5f} 99.9% {:.4f} (back {:.4f}, {:.4f})",
                           level.largest, level.mean, level.permille, outline.largest,
                           outline.permille);
    };
    fmt::print("{:<8} {:<8} away: {}\n{:<17} corners: {}\n", name, what,
               line(errors.levelAway, errors.outlineAway), "",
               line(errors.levelAtCorners, errors.outlineAtCorners));
}

// Smooth outlines need nothing more than the exact distances.
TEST(ShapeTruth, BilinearDistancesAreRightWhereOutlinesAreSmooth) {
    for (const std::string name : {"disc", "annulus"}) {
        const Case one(name);
        const OutlineErrors errors = one.errors(one.plain());
        print(name, "plain", errors);
        EXPECT_LT(errors.away(), 0.002);
    }
}

// What is known to be wrong is found to be: the measurement sees rounded corners.
TEST(ShapeTruth, BilinearDistancesRoundCorners) {
    for (const std::string name : {"star", "Ag"}) {
        const Case one(name);
        const OutlineErrors errors = one.errors(one.plain());
        print(name, "plain", errors);
        EXPECT_GT(errors.levelAtCorners.largest, 0.3);
        EXPECT_GT(errors.outlineAtCorners.largest, 1.0);  // tips are lost
    }
}

// A right angle in the middle of a cell, one sample inside: no bilinear function with the right
// signs, whose zeros on the sides of the cell are within 0.05 texel of the outline, comes nearer
// to the corner than 0.17. Along the diagonal f = −(1−t)² + (p + q)·t·(1−t) + r·t² for samples
// −1, p, q and r ≥ 0: its zero is the nearest to the corner at t = ½ for r = 0 and small p and q.
TEST(ShapeTruth, NoBilinearDistanceHasASharpCorner) {
    constexpr double kMost = 0.05;
    double nearest = HUGE_VAL;
    for (double crossing = 0.5 - kMost; crossing <= 0.5 + kMost; crossing += 0.001)
        for (double r = 0.0; r < 4.0; r += 0.01) {
            const double p = (1.0 - crossing) / crossing;  // the zero on the side is at `crossing`
            const auto f = [&](double t) {
                return -(1.0 - t) * (1.0 - t) + 2.0 * p * t * (1.0 - t) + r * t * t;
            };
            double low = 0.0;
            double high = 0.9;
            for (int k = 0; k < 50; ++k)
                (f(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
            nearest = std::min(nearest, std::sqrt(2.0) * std::abs(0.5 - low));
        }
    EXPECT_GT(nearest, 0.17);
}

TEST(ShapeTruth, CreasedDistancesAreRightAtCornersToo) {
    for (const std::string name : {"star", "Ag", "Relievo", "&"}) {
        const Case one(name);
        const CreasedDistances creased = one.creased();
        const OutlineErrors errors = one.errors(sampled(creased));
        print(name, "creased", errors);
        EXPECT_LT(errors.away(), 0.05) << name;
        EXPECT_LT(errors.atCorners(), 0.05) << name;
        EXPECT_EQ(creased.sharpCorners, static_cast<int>(cornersOf(one.contours).size()));
        EXPECT_EQ(creased.roundCorners, 0);
    }
}

// The same of what relievo-bake shape makes of a drawing.
TEST(ShapeTruth, BakedDrawingsAreRightAtCornersToo) {
    for (const std::string name : {"disc", "annulus", "star", "Ag"}) {
        const Case one(name);
        ShapeSource source;
        source.content = outlines::Drawing{{outlineOf(one.shape)}};
        source.width = source.height = kSize;
        const OutlineErrors errors = one.errors(bakedOf(source));
        print(name, "baked", errors);
        EXPECT_LT(errors.away(), 0.05) << name;
        EXPECT_LT(errors.atCorners(), 0.05) << name;
    }
}

// Bars and slits of 3 texels and less: corners there are left as they were.
TEST(ShapeTruth, CreasesDoNotHarmThinParts) {
    const Case comb("comb");
    const OutlineErrors plain = comb.errors(comb.plain());
    const OutlineErrors creased = comb.errors(sampled(comb.creased()));
    print("comb", "plain", plain);
    print("comb", "creased", creased);
    EXPECT_LE(creased.away(), plain.away() + 1e-6);
    EXPECT_LE(creased.atCorners(), plain.atCorners() + 1e-6);
}

// Corners of one angle anywhere in a texel and turned anyhow.
struct Wedge {
    std::vector<OutlineContour> contours;
    PlaneOutline outline;

    Wedge(double degrees, const glm::dvec2& place, double turn)
        : contours{{place, place + 300.0 * along(turn),
                    place + 450.0 * along(turn + 0.5 * degrees * kDegree),
                    place + 300.0 * along(turn + degrees * kDegree)}},
          outline(contours) {}

    [[nodiscard]] std::vector<BoundarySegment> boundary() const {
        std::vector<BoundarySegment> segments;
        for (std::size_t k = 0; k < 4; ++k)
            segments.push_back({contours[0][k], contours[0][(k + 1) % 4]});
        return segments;
    }

    // Of the centres of a map of size² texels.
    [[nodiscard]] textures::Plane distances(int size) const {
        textures::Plane exact(size, size);
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i)
                exact.at(i, j) = static_cast<float>(outline.distance({i + 0.5, j + 0.5}));
        return exact;
    }

    static constexpr double kDegree = std::numbers::pi / 180.0;
    static glm::dvec2 along(double angle) { return {std::cos(angle), std::sin(angle)}; }
};

TEST(ShapeTruth, CreasedCornersAreSharpAtAnyPlaceAndTurn) {
    constexpr int kMap = 40;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const double degrees : {36.0, 90.0, 120.0}) {
        double plain = 0.0;
        double creased = 0.0;
        for (int k = 0; k < 40; ++k) {
            const glm::dvec2 place(kMap / 2 + unit(random), kMap / 2 + unit(random));
            const Wedge wedge(degrees, place, 2.0 * std::numbers::pi * unit(random));
            const textures::Plane exact = wedge.distances(kMap);
            const auto largest = [&](const SampledDistance& field) {
                const OutlineErrors errors = measureErrors(field, wedge.contours, wedge.outline,
                                                           glm::ivec2(14), glm::ivec2(27), 64);
                return std::max(errors.away(), errors.atCorners());
            };
            plain = std::max(plain, largest({exact, {}}));
            creased = std::max(creased, largest(sampled(creaseCorners(wedge.boundary(), exact,
                                                                      textures::WrapMode::Clamp))));
        }
        fmt::print("{}°: plain {:.3f}, creased {:.3f}\n", degrees, plain, creased);
        EXPECT_GT(plain, 0.25);
        EXPECT_LT(creased, 0.05);
    }
}

// Outside of reflex corners the distance has a ridge, on which walls meet that lean outwards: it is
// creased as far as nothing else is nearer. Plain distances make steps of it.
TEST(ShapeTruth, RidgesOutsideOfReflexCornersAreSharp) {
    constexpr int kMap = 60;
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const double degrees : {240.0, 270.0, 324.0}) {
        double plain = 0.0;
        double creased = 0.0;
        for (int k = 0; k < 20; ++k) {
            const glm::dvec2 place(kMap / 2 + unit(random), kMap / 2 + unit(random));
            const Wedge wedge(degrees, place, 2.0 * std::numbers::pi * unit(random));
            const textures::Plane exact = wedge.distances(kMap);
            const SampledDistance field =
                sampled(creaseCorners(wedge.boundary(), exact, textures::WrapMode::Clamp));
            for (int point = 0; point < 2000; ++point) {
                const glm::dvec2 there =
                    place +
                    20.0 * unit(random) * Wedge::along(2.0 * std::numbers::pi * unit(random));
                const double distance = wedge.outline.distance(there);
                if (distance < 0.0)
                    continue;
                plain = std::max(plain, std::abs(SampledDistance{exact, {}}.at(there) - distance));
                creased = std::max(creased, std::abs(field.at(there) - distance));
            }
        }
        fmt::print("{}°: plain {:.3f}, creased {:.3f}\n", degrees, plain, creased);
        EXPECT_GT(plain, 0.2);
        EXPECT_LT(creased, 0.05);
    }
}

SampledDistance bakedOf(const textures::Plane& coverage) {
    ShapeSource source;
    source.content = coverage;
    source.width = source.height = kSize;
    return bakedOf(source);
}

// Anti-aliased bitmaps keep to a quarter of a texel, at corners too.
TEST(ShapeTruth, BitmapsOfCoverageAreNearTheirOutlines) {
    for (const std::string name : {"disc", "annulus", "star", "&", "Ag"}) {
        const Case one(name);
        const OutlineErrors errors = one.errors(bakedOf(one.coverage()));
        print(name, "bitmap", errors);
        EXPECT_LT(errors.away(), 0.25) << name;
        EXPECT_LT(errors.atCorners(), 0.25) << name;
    }
}

// The same of black and white alone is not: the check sees what anti-aliasing is good for.
TEST(ShapeTruth, BitmapsOfBlackAndWhiteAreNot) {
    const Case one("disc");
    textures::Plane coverage = one.coverage();
    for (float& texel : coverage.texels)
        texel = texel >= 0.5f ? 1.0f : 0.0f;
    const OutlineErrors errors = one.errors(bakedOf(coverage));
    print("disc", "hard", errors);
    EXPECT_GT(errors.away(), 0.25);
}

}  // namespace
}  // namespace relievo::preprocess
