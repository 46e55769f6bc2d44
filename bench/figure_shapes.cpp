#include "bench/figure_shapes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "outlines/curve_flattening.h"
#include "outlines/text_outline.h"
#include "preprocess/shape_baker.h"

namespace relievo::bench {
namespace {

using outlines::Contour;
using outlines::Drawing;
using outlines::FillRule;

constexpr double kTolerance = 2e-5;  // of curves, in tile widths
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSerif-Bold.ttf";

/// Draws a contour of lines and curves in units of its own.
class Pen {
  public:
    Pen(double unit, double x, double y) : unit_(unit), contour_{point(x, y)} {}
    Pen& line(double x, double y) {
        contour_.push_back(point(x, y));
        return *this;
    }
    Pen& curve(double x1, double y1, double x2, double y2, double x, double y) {
        outlines::appendCubic({contour_.back(), point(x1, y1), point(x2, y2), point(x, y)},
                              kTolerance, contour_);
        return *this;
    }
    /// Clockwise in the picture (with y downwards) for angles in turns that grow.
    Pen& arc(double x, double y, double radius, double from, double to) {
        constexpr int kChords = 96;
        for (int k = 0; k <= kChords; ++k) {
            const double angle = kTurn * (from + (to - from) * k / kChords);
            line(x + radius * std::cos(angle), y + radius * std::sin(angle));
        }
        return *this;
    }
    operator Contour() const { return contour_; }

  private:
    glm::dvec2 point(double x, double y) const { return glm::dvec2(x, y) / unit_; }

    double unit_;
    Contour contour_;
};

// Around the middle of a square tile; `radius` is of angles in turns.
template <typename Radius>
Contour polar(int points, Radius radius) {
    Contour contour;
    for (int k = 0; k < points; ++k) {
        const double turn = static_cast<double>(k) / points;
        contour.push_back(glm::dvec2(0.5) + radius(turn, k) * glm::dvec2(std::sin(kTurn * turn),
                                                                         -std::cos(kTurn * turn)));
    }
    return contour;
}

Contour circle(double radius) {
    return polar(512, [=](double, int) { return radius; });
}

Contour rectangle(double unit, double x, double y, double width, double height) {
    return Pen(unit, x, y).line(x + width, y).line(x + width, y + height).line(x, y + height);
}

Drawing drawingOf(std::vector<Contour> contours, double aspect = 1.0) {
    return {{{std::move(contours), FillRule::EvenOdd}}, aspect};
}

Drawing gear() {
    // Root, flank and tip of each of twelve teeth: where they begin, and how far from the middle.
    constexpr int kTeeth = 12;
    constexpr std::array kParts = {glm::dvec2(0.0, 0.35), glm::dvec2(0.42, 0.35),
                                   glm::dvec2(0.54, 0.44), glm::dvec2(0.88, 0.44)};
    Contour rim;
    for (int tooth = 0; tooth < kTeeth; ++tooth)
        for (const glm::dvec2& part : kParts) {
            const double angle = kTurn * (tooth + part.x) / kTeeth;
            rim.push_back(glm::dvec2(0.5) + part.y * glm::dvec2(std::sin(angle), -std::cos(angle)));
        }
    return drawingOf({std::move(rim), circle(0.13)});
}

Drawing star() {
    return drawingOf({polar(10, [](double, int k) { return k % 2 == 0 ? 0.45 : 0.19; })});
}

Drawing flower() {
    return drawingOf(
        {polar(720, [](double turn, int) { return 0.33 + 0.09 * std::cos(6.0 * kTurn * turn); })});
}

// The section of a fluted column.
Drawing column() {
    return drawingOf({polar(640, [](double turn, int) {
        return 0.22 - 0.025 * std::abs(std::sin(8.0 * kTurn * turn));
    })});
}

Drawing heart() {
    return drawingOf({Pen(100, 50, 90)
                          .curve(30, 72, 8, 56, 8, 34)
                          .curve(8, 10, 40, 6, 50, 28)
                          .curve(60, 6, 92, 10, 92, 34)
                          .curve(92, 56, 70, 72, 50, 90)});
}

Drawing arrow() {
    return drawingOf({Pen(100, 14, 40)
                          .line(50, 40)
                          .line(50, 20)
                          .line(86, 50)
                          .line(50, 80)
                          .line(50, 60)
                          .line(14, 60)},
                     1.0);
}

Drawing meander() {
    Drawing drawing;
    drawing.aspect = 9.0 / 8.0;
    for (const auto& [x, y, width, height] :
         {std::array{-1.0, 7.0, 10.0, 1.0}, std::array{0.0, 1.0, 1.0, 7.0},
          std::array{0.0, 1.0, 7.0, 1.0}, std::array{6.0, 1.0, 1.0, 5.0},
          std::array{2.0, 5.0, 5.0, 1.0}, std::array{2.0, 3.0, 1.0, 3.0},
          std::array{2.0, 3.0, 3.0, 1.0}})
        drawing.shapes.push_back({{rectangle(8, x, y, width, height)}, FillRule::NonZero});
    return drawing;
}

// Bands around stars of eight points, and small ones between them.
Drawing lattice() {
    const auto eight = [](double size) {
        return polar(16, [=](double, int k) { return k % 2 == 0 ? size : 0.765 * size; });
    };
    std::vector<Contour> contours = {rectangle(1, -0.5, -0.5, 2, 2), eight(0.41)};
    for (const glm::dvec2 corner :
         {glm::dvec2(-0.5), glm::dvec2(0.5, -0.5), glm::dvec2(-0.5, 0.5), glm::dvec2(0.5)}) {
        Contour& small = contours.emplace_back(eight(0.17));
        for (glm::dvec2& point : small)
            point += corner;
    }
    return drawingOf(std::move(contours));
}

// Sections: of a tile width of 100 the axis is at 0, and the solid within 50. They go beyond the
// axis, and beyond the lower border where it is to cut them off.

Drawing pawn() {
    return drawingOf({Pen(100, -8, 8)
                          .line(0, 8)
                          .arc(0, 29, 21, -0.25, 0.1422)
                          .curve(20, 48, 26, 50, 26, 53)
                          .curve(26, 56, 20, 57, 15, 58)
                          .curve(14, 78, 19, 98, 28, 109)
                          .line(28, 113)
                          .curve(34, 114, 36, 116, 36, 119)
                          .curve(36, 122, 35, 123, 33, 124)
                          .curve(41, 126, 44, 130, 44, 137)
                          .line(44, 160)
                          .line(-8, 160)},
                     1.47);
}

Drawing goblet() {
    return drawingOf({Pen(100, -8, 66)
                          .line(0, 66)
                          .curve(22, 66, 33, 48, 36, 6)
                          .curve(36, 4, 39, 4, 39, 6)
                          .curve(38, 52, 28, 70, 8, 76)
                          .curve(5, 78, 5, 82, 9, 84)
                          .curve(13, 86, 13, 91, 9, 93)
                          .curve(4, 95, 4, 112, 6, 122)
                          .curve(8, 130, 32, 130, 34, 136)
                          .line(34, 160)
                          .line(-8, 160)},
                     1.4);
}

Drawing vase() {
    return drawingOf({Pen(100, -8, 118)
                          .line(0, 118)
                          .curve(20, 118, 36, 78, 36, 60)
                          .curve(36, 40, 12, 38, 14, 22)
                          .curve(14, 12, 20, 8, 25, 6)
                          .curve(26, 4, 29, 6, 28, 8)
                          .curve(18, 14, 16, 20, 18, 26)
                          .curve(20, 36, 44, 38, 44, 60)
                          .curve(44, 88, 24, 110, 18, 128)
                          .curve(18, 132, 24, 132, 25, 136)
                          .line(25, 160)
                          .line(-8, 160)},
                     1.42);
}

Drawing baluster() {
    return drawingOf({Pen(100, -8, -9)
                          .line(22, -9)
                          .line(22, 8)
                          .line(16, 8)
                          .curve(22, 10, 22, 16, 16, 18)
                          .line(10, 20)
                          .curve(8, 50, 32, 72, 32, 100)
                          .curve(32, 122, 14, 126, 12, 134)
                          .line(18, 136)
                          .curve(24, 138, 24, 146, 18, 148)
                          .line(26, 148)
                          .line(26, 180)
                          .line(-8, 180)},
                     1.65);
}

Drawing bell() {
    return drawingOf({Pen(100, -8, 4)
                          .line(0, 4)
                          .curve(8, 4, 9, 16, 3, 19)
                          .curve(18, 20, 20, 28, 20, 38)
                          .curve(21, 62, 28, 74, 44, 84)
                          .curve(46, 86, 46, 92, 42, 92)
                          .line(38, 90)
                          .curve(26, 80, 15, 66, 14, 40)
                          .curve(14, 34, 8, 32, 0, 32)
                          .line(-8, 32)},
                     0.96);
}

Drawing top() {
    return drawingOf({Pen(100, -8, 4)
                          .line(3, 4)
                          .line(4, 26)
                          .curve(20, 27, 46, 34, 46, 46)
                          .curve(46, 60, 14, 78, 1, 104)
                          .line(0, 105)
                          .line(-8, 105)},
                     1.08);
}

Drawing bowl() {
    return drawingOf({Pen(100, -8, 40)
                          .line(0, 40)
                          .curve(24, 40, 38, 30, 43, 6)
                          .curve(44, 4, 47, 4, 47, 7)
                          .curve(44, 36, 30, 46, 20, 49)
                          .line(22, 56)
                          .line(22, 80)
                          .line(-8, 80)},
                     0.6);
}

Drawing torus() {
    return drawingOf({Pen(100, 45, 16).arc(31, 16, 14, 0.0, 1.0)}, 0.32);
}

Drawing ball() {
    return drawingOf({Pen(100, -8, 4).line(0, 4).arc(0, 50, 46, -0.25, 0.25).line(-8, 96)});
}

struct NamedDrawing {
    std::string_view name;
    Drawing (*draw)();
};
constexpr NamedDrawing kDrawings[] = {
    {"arrow", arrow},
    {"gear", gear},
    {"star", star},
    {"heart", heart},
    {"flower", flower},
    {"column", column},
    {"ring",
     [] {
         return drawingOf({circle(0.46), circle(0.33)});
     }},
    {"meander", meander},
    {"lattice", lattice},
    {"ampersand", [] { return outlines::readTextDrawing(kFont, "&", kTolerance); }},
    {"R", [] { return outlines::readTextDrawing(kFont, "R", kTolerance); }},
    {"pawn", pawn},
    {"goblet", goblet},
    {"vase", vase},
    {"baluster", baluster},
    {"bell", bell},
    {"top", top},
    {"bowl", bowl},
    {"torus", torus},
    {"ball", ball},
};

}  // namespace

Drawing figureDrawing(std::string_view name) {
    const auto found = std::ranges::find(kDrawings, name, &NamedDrawing::name);
    assert(found != std::end(kDrawings));
    return found->draw();
}

std::shared_ptr<const textures::ShapeMap> figureShape(std::string_view name, int width,
                                                      textures::WrapMode wrap,
                                                      bool hasSharpCorners) {
    preprocess::ShapePlan plan;
    plan.hasSharpCorners = hasSharpCorners;
    plan.wrap = wrap;
    plan.width = width;
    preprocess::ShapeSource source;
    source.content = figureDrawing(name);
    const auto size =
        preprocess::shapeSize(std::string(name), std::get<Drawing>(source.content).aspect, plan);
    source.width = size.width;
    source.height = size.height;
    return std::make_shared<textures::ShapeMap>(preprocess::bakeShape(source, plan));
}

}  // namespace relievo::bench
