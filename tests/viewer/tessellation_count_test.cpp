// Counts of triangles against closed forms.
#include "viewer/tessellation_count.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/textures/temporary_folder.h"

namespace relievo::viewer {
namespace {

using outlines::Contour;
using textures::WrapMode;

Contour polygon(int corners, glm::dvec2 centre, double radius) {
    Contour contour;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners + 0.1;
        contour.push_back(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return contour;
}

Contour rectangle(double left, double top, double right, double bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

outlines::Drawing drawingOf(std::vector<Contour> contours,
                            outlines::FillRule rule = outlines::FillRule::EvenOdd) {
    return {{{std::move(contours), rule}}, 1.0};
}

ShapeBoundary boundaryOf(const outlines::Drawing& drawing) {
    return viewer::boundaryOf(drawing, glm::dvec2(1.0), WrapMode::Clamp);
}

TEST(TessellationCount, PrismHasTwoFansAndItsSides) {
    for (const int n : {3, 4, 7, 48}) {
        const ShapeBoundary boundary = boundaryOf(drawingOf({polygon(n, glm::dvec2(0.5), 0.4)}));
        const auto corners = static_cast<std::size_t>(n);
        EXPECT_EQ(boundary.vertices, corners);
        EXPECT_EQ(extrusionTriangles(boundary, 1), 2 * (corners - 2) + 2 * corners);
        EXPECT_EQ(extrusionTriangles(boundary, 5), 2 * (corners - 2) + 10 * corners);
    }
}

// A cap between two n-gons takes 2n triangles, by closing the strip between them.
TEST(TessellationCount, HolesAreBridged) {
    const ShapeBoundary ring = boundaryOf(
        drawingOf({polygon(12, glm::dvec2(0.5), 0.4), polygon(12, glm::dvec2(0.5), 0.2)}));
    EXPECT_EQ(ring.holes, 1u);
    EXPECT_EQ(ring.pieces(), 1u);
    EXPECT_EQ(extrusionTriangles(ring, 1), 2 * 24u + 2 * 24u);
    // Forgetting the hole, as if both were pieces, gives another number.
    const ShapeBoundary apart =
        boundaryOf(drawingOf({polygon(12, {0.25, 0.5}, 0.2), polygon(12, {0.75, 0.5}, 0.2)}));
    EXPECT_EQ(extrusionTriangles(apart, 1), 2 * 20u + 2 * 24u);
}

TEST(TessellationCount, OverlapsAndStraightPointsCountNothing) {
    outlines::Drawing drawing = drawingOf({rectangle(0.1, 0.1, 0.6, 0.5)});
    drawing.shapes.push_back({{rectangle(0.4, 0.1, 0.9, 0.5)}, outlines::FillRule::NonZero});
    EXPECT_EQ(boundaryOf(drawing).vertices, 4u);
    EXPECT_EQ(boundaryOf(drawing).pieces(), 1u);
}

TEST(TessellationCount, CylinderConeSphereAndTorus) {
    const std::size_t sectors = 16;
    const auto triangles = [&](const Contour& section) {
        return revolutionTriangles(boundaryOf(drawingOf({section})), sectors);
    };
    // Two fans and a strip of two triangles a sector; what is beyond the axis is cut off.
    EXPECT_EQ(triangles(rectangle(-0.1, 0.2, 0.4, 0.8)), 4 * sectors);
    EXPECT_EQ(triangles({{0.0, 0.2}, {0.4, 0.8}, {0.0, 0.8}}), 2 * sectors);
    EXPECT_EQ(triangles(polygon(9, {0.5, 0.5}, 0.3)), 2 * 9 * sectors) << "a torus";
    // Half of a 2k-gon whose ends are on the axis: k edges, of which two touch it.
    Contour half;
    for (int k = 0; k <= 10; ++k)
        half.emplace_back(0.4 * std::sin(std::numbers::pi * k / 10),
                          0.5 - 0.4 * std::cos(std::numbers::pi * k / 10));
    half.back().x = 0.0;
    EXPECT_EQ(triangles(half), (2 * 10 - 2) * sectors) << "a sphere";
}

TEST(TessellationCount, SectorsKeepTheToleranceAndNoFewerDo) {
    for (const double tolerance : {0.1, 0.01, 0.0005}) {
        const auto deviation = [](std::size_t n) {
            return 1.0 - std::cos(std::numbers::pi / static_cast<double>(n));
        };
        const std::size_t sectors = circleSectors(2.0, 2.0 * tolerance);
        EXPECT_LE(deviation(sectors), tolerance * (1.0 + 1e-9));
        EXPECT_GT(deviation(sectors - 1), tolerance);
    }
    EXPECT_EQ(circleSectors(1.0, 5.0), 3u);
}

TEST(TessellationCount, TilesJoinAndAreCut) {
    const outlines::Drawing bar = drawingOf({rectangle(-0.5, 0.4, 1.5, 0.6)});
    const ShapeBoundary joined = viewer::boundaryOf(bar, {5.0, 1.0}, WrapMode::Repeat);
    EXPECT_EQ(joined.vertices, 4u);
    EXPECT_EQ(joined.pieces(), 1u);
    const outlines::Drawing square = drawingOf({rectangle(0.3, 0.3, 0.7, 0.7)});
    const ShapeBoundary apart = viewer::boundaryOf(square, {3.0, 2.0}, WrapMode::Repeat);
    EXPECT_EQ(apart.vertices, 24u);
    EXPECT_EQ(apart.pieces(), 6u);
    EXPECT_EQ(viewer::boundaryOf(square, {2.2, 1.0}, WrapMode::Repeat).pieces(), 2u);
    EXPECT_EQ(viewer::boundaryOf(square, {2.5, 1.0}, WrapMode::Repeat).pieces(), 3u);
    // Two triangles that meet at the border, mirrored: one of them.
    const outlines::Drawing corner = drawingOf({{{1.0, 0.3}, {1.0, 0.7}, {0.6, 0.7}}});
    EXPECT_EQ(viewer::boundaryOf(corner, {2.0, 1.0}, WrapMode::Mirror).pieces(), 1u);
    EXPECT_EQ(viewer::boundaryOf(corner, {2.0, 1.0}, WrapMode::Mirror).vertices, 3u);
    EXPECT_EQ(viewer::boundaryOf(corner, {2.0, 1.0}, WrapMode::Repeat).pieces(), 2u);
    EXPECT_EQ(viewer::boundaryOf(corner, {2.0, 1.0}, WrapMode::Clamp).pieces(), 1u);
}

TEST(TessellationCount, ChordsOfProfiles) {
    const auto chords = [](const solids::Profile& profile, double tolerance) {
        return profileChords(profile, 1.0, 1.0, tolerance);
    };
    EXPECT_EQ(chords(solids::makeProfile(0.2), 1e-6), 1u);
    EXPECT_EQ(chords(solids::makeProfile(0.0, 0.3, 0.5), 1e-6), 2u);
    EXPECT_EQ(chords(solids::makeProfile(0.0, 0.3, 1.0, solids::ProfileShape::Round), 1e-6),
              static_cast<std::size_t>(solids::kRoundPieces));
    // Chords over 22.5° of a quarter circle are 0.019 of its radius off, over 30° 0.034.
    EXPECT_EQ(chords(solids::makeProfile(0.0, 1.0, 1.0, solids::ProfileShape::Round), 0.0215), 4u);
    // Two straight pieces and the level step between them.
    const std::array<glm::dvec2, 4> stairs{{{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.2}, {1.0, 0.2}}};
    EXPECT_EQ(chords(solids::profileThrough(stairs), 1e-6), 3u);
}

class TessellationOfScenes : public textures::TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        textures::writeBytes(
            file("square.svg"),
            "<svg viewBox='0 0 10 10'><rect x='1' y='1' width='8' height='8'/></svg>");
        textures::writeBytes(file("disc.svg"),
                             "<svg viewBox='0 0 10 10'><circle cx='5' cy='5' r='4'/></svg>");
    }
    SceneTriangles count(const std::string& boxes) {
        textures::writeBytes(
            file("scene.json"),
            R"({"shapes": {"square": {"svg": "square.svg"}, "disc": {"svg": "disc.svg"},
                                 "baked": {"map": "baked.exr"}}, "boxes": [)" +
                boxes + "]}");
        return countTriangles(readSceneFile(file("scene.json")));
    }
};

TEST_F(TessellationOfScenes, CountsCopiesOfBoxesAndAllTheirParts) {
    const SceneTriangles triangles =
        count(R"({"size": [1, 1, 1], "repeat": [{"count": 3, "step": [2, 0, 0]}],
                  "parts": [{"shape": "square", "kind": "extrusion"},
                            {"shape": "square", "kind": "extrusion", "operation": "difference"},
                            {"shape": "baked", "kind": "extrusion"}]},
                 {"size": [1, 1, 1], "parts": [{"shape": "square", "kind": "extrusion"}]})");
    EXPECT_EQ(triangles.boxes, 4u);
    EXPECT_EQ(triangles.drawn, 48u);
    EXPECT_EQ(triangles.tessellated, 7 * 12u);
    EXPECT_EQ(triangles.uncounted, 3u);
}

TEST_F(TessellationOfScenes, TheToleranceIsAShareOfTheBox) {
    // The disc turned around its tile's left border: a torus, finer along the ring.
    const std::string torus =
        R"({"size": [%, %, %], "parts": [{"shape": "disc", "kind": "revolution"}]})";
    const auto sized = [&](const std::string& size) {
        std::string text = torus;
        for (std::size_t at = text.find('%'); at != std::string::npos; at = text.find('%'))
            text.replace(at, 1, size);
        return count(text).tessellated;
    };
    EXPECT_EQ(sized("1"), sized("100")) << "the same solid of another size";
    const std::size_t sectors = circleSectors(0.9, kTessellationTolerance * std::sqrt(3.0));
    EXPECT_EQ(sized("1") % (2 * sectors), 0u);
    EXPECT_GT(sized("1"), 2 * sectors * 12);
}

}  // namespace
}  // namespace relievo::viewer
