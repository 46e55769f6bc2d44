// How far the zero level of baked distances is from the true outline, at 512²: analytic shapes and
// letters, from vector outlines and from anti-aliased bitmaps, away from corners and at them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "coverage_lines.h"
#include "coverage_outline.h"
#include "creased_distance.h"
#include "outline_error.h"
#include "outlines/text_outline.h"
#include "preprocess/boundary_distance.h"
#include "preprocess/boundary_tree.h"
#include "preprocess/inside_mask.h"
#include "preprocess/plane_shape.h"
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

struct Case {
    SampleOutline shape;
    std::vector<OutlineContour> contours;  // in texels
    PlaneOutline outline;
    textures::Plane distance;

    explicit Case(const std::string& name)
        : shape(sample(name)),
          contours(inTexels(shape.contours)),
          outline(contours, shape.filling),
          distance(
              signedDistances(shapeOf(outlineOf(shape), kSize, kSize, textures::WrapMode::Clamp))) {
    }

    [[nodiscard]] OutlineErrors errors(CornerMethod method,
                                       CreaseStatistics* statistics = nullptr) const {
        return measureErrors(
            sampleDistance(distance, contours, cornersOf(contours), outline, method, statistics),
            contours, outline, glm::ivec2(1), glm::ivec2(kSize - 1));
    }
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

TEST(ShapeTruth, Report) {
    for (const std::string name : {"disc", "annulus", "star", "comb", "Ag", "Relievo", "&"}) {
        const Case one(name);
        print(name, "plain", one.errors(CornerMethod::Plain));
        if (cornersOf(one.contours).empty())
            continue;
        CreaseStatistics statistics;
        print(name, "creased", one.errors(CornerMethod::Creased, &statistics));
        fmt::print("corners {} dropped {} samples {} conflicts {}\n", statistics.corners,
                   statistics.dropped, statistics.samples, statistics.conflicts);
    }
}

textures::Plane distancesOf(const textures::Plane& coverage) {
    textures::Plane plane =
        measureBoundaryDistances(buildBoundaryTree(halfLevel(coverage)), kSize, kSize).distance;
    for (std::size_t k = 0; k < plane.texels.size(); ++k)
        if (coverage.texels[k] >= 0.5f)
            plane.texels[k] = -plane.texels[k];
    return plane;
}

TEST(ShapeTruth, ReportOfCoverage) {
    for (const std::string name : {"disc", "annulus", "star", "comb", "Ag", "Relievo", "&"}) {
        const Case one(name);
        const textures::Plane coverage =
            coverageOf(shapeOf(outlineOf(one.shape), kSize, kSize, textures::WrapMode::Clamp),
                       kSize, kSize, 255);
        const SampledDistance field{distancesOf(coverage), {}, 0.0};
        print(
            name, "coverage",
            measureErrors(field, one.contours, one.outline, glm::ivec2(1), glm::ivec2(kSize - 1)));
        const FittedOutline fitted = fittedOutline(coverage);
        const PlaneOutline outline(fitted.contours, reference::Filling::EvenOdd);
        textures::Plane exact(kSize, kSize);
        for (int j = 0; j < kSize; ++j)
            for (int i = 0; i < kSize; ++i)
                exact.at(i, j) = static_cast<float>(outline.distance({i + 0.5, j + 0.5}));
        CreaseStatistics statistics;
        for (const CornerMethod method : {CornerMethod::Plain, CornerMethod::Creased})
            print(name, method == CornerMethod::Plain ? "lines" : "creased",
                  measureErrors(sampleDistance(exact, fitted.contours, fitted.corners, outline,
                                               method, &statistics),
                                one.contours, one.outline, glm::ivec2(1), glm::ivec2(kSize - 1)));
        fmt::print(
            "vertices {} on lines {} corners {} left {}; creased {} dropped {} conflicts {}\n",
            fitted.statistics.vertices, fitted.statistics.onLines, fitted.statistics.corners,
            fitted.statistics.left, statistics.corners, statistics.dropped, statistics.conflicts);
    }
}

}  // namespace
}  // namespace relievo::preprocess
