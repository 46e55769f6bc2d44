// Glyphs of the font that the viewer's labels have.
#include "outlines/text_outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "outline_area.h"
#include "tests/textures/temporary_folder.h"

namespace relievo::outlines {
namespace {

using testing::HasSubstr;

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

class TextOutline : public textures::TemporaryFolder {
  protected:
    static std::string errorOf(const std::filesystem::path& font, const std::string& text) {
        try {
            readTextDrawing(font, text, 1e-4);
        } catch (const textures::InputError& error) {
            return error.what();
        }
        return "no error";
    }
};

TEST_F(TextOutline, FillsTheTileButForItsMargin) {
    const Drawing drawing = readTextDrawing(kFont, "HOH", 1e-4);
    glm::dvec2 least(HUGE_VAL);
    glm::dvec2 most(-HUGE_VAL);
    for (const Contour& contour : drawing.shapes.front().contours)
        for (const glm::dvec2& point : contour)
            for (int axis = 0; axis < 2; ++axis) {
                least[axis] = std::min(least[axis], point[axis]);
                most[axis] = std::max(most[axis], point[axis]);
            }
    const double margin = least.x;
    EXPECT_GT(margin, 0.0);
    EXPECT_NEAR(most.x, 1.0 - margin, 1e-3);
    EXPECT_NEAR(least.y, margin, 1e-3);
    EXPECT_NEAR(most.y, drawing.aspect - margin, 1e-3);
    EXPECT_NEAR(margin, 0.125 * (most.y - least.y), 1e-3);
}

TEST_F(TextOutline, HolesGoAroundTheOtherWay) {
    const Drawing drawing = readTextDrawing(kFont, "O", 1e-4);
    const std::vector<Contour>& contours = drawing.shapes.front().contours;
    ASSERT_EQ(contours.size(), 2u);
    EXPECT_LT(signedArea(contours[0]) * signedArea(contours[1]), 0.0);
}

TEST_F(TextOutline, IsUpright) {
    // The bar of a T is at the top, where y is small.
    const Drawing drawing = readTextDrawing(kFont, "T", 1e-4);
    const Contour& t = drawing.shapes.front().contours.front();
    double top = 0.0;
    double bottom = 0.0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        const glm::dvec2& a = t[k];
        const glm::dvec2& b = t[(k + 1) % t.size()];
        if (a.y == b.y)
            (a.y < 0.3 ? top : bottom) = std::max(a.y < 0.3 ? top : bottom, std::abs(a.x - b.x));
    }
    EXPECT_GT(top, 3.0 * bottom);
}

TEST_F(TextOutline, WrongInputIsRefusedInOneSentence) {
    EXPECT_THAT(errorOf(kFont, " "), HasSubstr("covers nothing"));
    EXPECT_THAT(errorOf(kFont, "A\xF3\xB0\x80\x80"),
                HasSubstr("no glyph for what begins at byte 1"));
    EXPECT_THAT(errorOf(file("none.ttf"), "A"), HasSubstr("cannot be read"));
    std::ofstream(file("wrong.ttf")) << "no font";
    EXPECT_THAT(errorOf(file("wrong.ttf"), "A"), HasSubstr("is no font"));
}

}  // namespace
}  // namespace relievo::outlines
