// Drawings against their areas in closed form, and wrong files.
#include "outlines/svg_outline.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "outline_area.h"
#include "tests/textures/temporary_folder.h"

namespace relievo::outlines {
namespace {

using testing::HasSubstr;

constexpr double kTolerance = 1e-6;

class SvgOutline : public textures::TemporaryFolder {
  protected:
    // A document of 200×100 units.
    Drawing read(const std::string& content,
                 const std::string& attributes = "viewBox='0 0 200 100'") {
        const std::filesystem::path path = file("drawing.svg");
        std::ofstream(path) << "<svg xmlns='http://www.w3.org/2000/svg' " << attributes << ">"
                            << content << "</svg>";
        return readSvgDrawing(path, kTolerance);
    }
    // In units of the document.
    double area(const std::string& content) {
        return 200.0 * 200.0 * signedArea(read(content).shapes);
    }
    std::string errorOf(const std::string& content,
                        const std::string& attributes = "viewBox='0 0 200 100'") {
        try {
            read(content, attributes);
        } catch (const textures::InputError& error) {
            return error.what();
        }
        return "no error";
    }
};

TEST_F(SvgOutline, BasicShapesHaveTheirAreas) {
    EXPECT_NEAR(area("<rect x='10' y='5' width='30' height='20'/>"), 600.0, 1e-9);
    EXPECT_NEAR(area("<rect width='30' height='20' rx='5'/>"),
                600.0 - (4.0 - std::numbers::pi) * 25.0, 0.05);
    EXPECT_NEAR(std::abs(area("<circle cx='50' cy='50' r='20'/>")), std::numbers::pi * 400.0, 0.05);
    EXPECT_NEAR(std::abs(area("<ellipse cx='50' cy='50' rx='20' ry='10'/>")),
                std::numbers::pi * 200.0, 0.05);
    EXPECT_NEAR(area("<polygon points='0,0 10,0 10,10'/>"), 50.0, 1e-9);
    EXPECT_NEAR(area("<path d='M0 0 h10 v10 h-10 z m2 2 v6 h6 v-6 z'/>"), 100.0 - 36.0, 1e-9);
}

TEST_F(SvgOutline, CurvesHaveTheirAreas) {
    // A parabola over its chord: two thirds of the box.
    EXPECT_NEAR(std::abs(area("<path d='M0,0 Q50,100 100,0 z'/>")), 2.0 / 3.0 * 100.0 * 50.0, 0.1);
    EXPECT_NEAR(std::abs(area("<path d='M0,50 A50,50 0 0 1 100,50 z'/>")),
                0.5 * std::numbers::pi * 2500.0, 0.1);
}

TEST_F(SvgOutline, TransformsComeInTheirOrder) {
    const Drawing drawing = read(
        "<g transform='translate(100,0)'><rect transform='rotate(90) scale(2,3)' x='1' y='0' "
        "width='4' height='5'/></g>");
    EXPECT_NEAR(signedArea(drawing.shapes) * 200.0 * 200.0, 20.0 * 6.0, 1e-9);
    // (1,0) → (2,0) → (0,2) → (100,2)
    const glm::dvec2 first = drawing.shapes.front().contours.front().front();
    EXPECT_NEAR(first.x, 100.0 / 200.0, 1e-12);
    EXPECT_NEAR(first.y, 2.0 / 200.0, 1e-12);
}

TEST_F(SvgOutline, WhatIsNotFilledDoesNotCount) {
    EXPECT_TRUE(read("<rect width='5' height='5' fill='none'/>").shapes.empty());
    EXPECT_TRUE(
        read("<g style='stroke:red; fill: none'><rect width='5' height='5'/></g>").shapes.empty());
    EXPECT_TRUE(read("<rect width='5' height='5' display='none'/>").shapes.empty());
    EXPECT_EQ(read("<g fill='none'><rect width='5' height='5' fill='red'/></g>").shapes.size(), 1u);
}

TEST_F(SvgOutline, TileAndFillRule) {
    const Drawing drawing = read("<path fill-rule='evenodd' d='M0 0h1v1z'/><path d='M0 0h1v1z'/>");
    EXPECT_EQ(drawing.aspect, 0.5);
    EXPECT_EQ(drawing.shapes[0].rule, FillRule::EvenOdd);
    EXPECT_EQ(drawing.shapes[1].rule, FillRule::NonZero);
    EXPECT_EQ(read("", "width='10px' height='30'").aspect, 3.0);
    // The corner of the view box is that of the tile.
    const Drawing moved =
        read("<rect x='-50' y='20' width='10' height='10'/>", "viewBox='-50 10 100 100'");
    EXPECT_NEAR(moved.shapes[0].contours[0][0].x, 0.0, 1e-12);
    EXPECT_NEAR(moved.shapes[0].contours[0][0].y, 0.1, 1e-12);
}

TEST_F(SvgOutline, WrongFilesAreRefusedInOneSentence) {
    EXPECT_THAT(errorOf("<path d='M0 0 L nowhere'/>"), HasSubstr("no path of SVG's"));
    EXPECT_THAT(errorOf("<path d='M0 0h1v1z' transform='turn(3)'/>"), HasSubstr("'turn(3)'"));
    EXPECT_THAT(errorOf("<rect width='5cm' height='1'/>"), HasSubstr("width='5cm'"));
    EXPECT_THAT(errorOf("<text>A</text>"), HasSubstr("<text>"));
    EXPECT_THAT(errorOf("<use href='#a'/>"), HasSubstr("not supported"));
    EXPECT_THAT(errorOf("", "width='0' height='5'"), HasSubstr("has no size"));
    EXPECT_THAT(errorOf("<rect"), HasSubstr("cannot be read as SVG"));
    EXPECT_THROW(readSvgDrawing(file("none.svg"), kTolerance), textures::InputError);
}

}  // namespace
}  // namespace relievo::outlines
