#include "reference/sample_outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace relievo::reference {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTexel = 1.0 / 512.0;

// Sides of a pentagram meet at 36°: the inner radius is 1/φ² of the outer one.
OutlineContour star(const glm::dvec2& centre, double radius, double turn) {
    const double inner = radius / (std::numbers::phi * std::numbers::phi);
    OutlineContour contour;
    for (int k = 0; k < 10; ++k) {
        const double angle = turn + kPi * k / 5.0;
        contour.push_back(centre + (k % 2 == 0 ? radius : inner) *
                                       glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return contour;
}

// Bars joined at their lower ends, each a little narrower than the one before, as are the slits.
OutlineContour comb() {
    OutlineContour contour{{0.1003, 0.8007}, {0.1003, 0.2011}};
    double x = 0.1003;
    for (int k = 0; k < 10; ++k) {
        const double width = (3.0 - 0.25 * k) * kTexel;
        x += width;
        contour.emplace_back(x, 0.2011);
        contour.emplace_back(x, 0.7003);
        x += k < 9 ? width : 0.0;
        if (k < 9) {
            contour.emplace_back(x, 0.7003);
            contour.emplace_back(x, 0.2011);
        }
    }
    contour.emplace_back(0.9001, 0.7003);
    contour.emplace_back(0.9001, 0.8007);
    return contour;
}

// A half in s ≥ 0, from the axis above to the axis below, and its mirror image.
OutlineContour onBothSides(const OutlineContour& half) {
    OutlineContour contour = half;
    for (auto point = half.rbegin(); point != half.rend(); ++point)
        if (point->x != 0.0)
            contour.emplace_back(-point->x, point->y);
    return contour;
}

// Cubic Hermite (Catmull-Rom) spline through knots. In 4096 pieces of which none is longer than
// 1/4096 and bends by more than 1/800 the chords are within 1e-7 texels of the curve.
OutlineContour spline(const std::vector<glm::dvec2>& knots) {
    constexpr int kPieces = 4096;
    OutlineContour contour;
    const int last = static_cast<int>(knots.size()) - 1;
    const auto knot = [&](int k) {
        return knots[static_cast<std::size_t>(std::clamp(k, 0, last))];
    };
    for (int k = 0; k < last; ++k)
        for (int piece = 0; piece < kPieces; ++piece) {
            const double t = static_cast<double>(piece) / kPieces;
            const glm::dvec2 start = 0.5 * (knot(k + 1) - knot(k - 1));
            const glm::dvec2 end = 0.5 * (knot(k + 2) - knot(k));
            const double t2 = t * t;
            const double t3 = t2 * t;
            contour.push_back((2 * t3 - 3 * t2 + 1) * knot(k) + (t3 - 2 * t2 + t) * start +
                              (3 * t2 - 2 * t3) * knot(k + 1) + (t3 - t2) * end);
        }
    contour.push_back(knots.back());
    return contour;
}

// Lip, neck, belly and foot, a flat bottom, and a hollow that is open above.
OutlineContour vase() {
    OutlineContour half =
        spline({{0.17, 0.05}, {0.11, 0.2}, {0.33, 0.5}, {0.24, 0.78}, {0.13, 0.88}, {0.19, 0.95}});
    half.insert(half.begin(), {{0.0, 0.6}, {0.1, 0.6}, {0.06, 0.2}, {0.13, 0.05}});
    half.emplace_back(0.0, 0.95);
    return onBothSides(half);
}

}  // namespace

OutlineContour circleContour(const glm::dvec2& centre, double radius, double tolerance) {
    // The sagitta of a chord over the angle 2α is radius·(1 − cos α), next to radius·α²/2.
    const double step = 2.0 * std::sqrt(2.0 * std::min(tolerance / radius, 0.5));
    const int count = std::max(3, static_cast<int>(std::ceil(2.0 * kPi / step)));
    OutlineContour contour;
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * kPi * k / count;
        contour.push_back(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return contour;
}

std::vector<SampleOutline> sampleShapes() {
    const glm::dvec2 centre(0.5013, 0.4987);
    return {
        {"disc", {circleContour(centre, 0.3)}},
        {"annulus", {circleContour(centre, 0.35), circleContour(centre, 0.2)}, Filling::EvenOdd},
        {"star", {star(centre, 0.42, 0.3)}},
        {"comb", {comb()}}};
}

std::vector<SampleOutline> sampleSections() {
    using Cone = ConeSection;
    const OutlineContour ring =
        circleContour({TorusSection::kRing, TorusSection::kHeight}, TorusSection::kTube);
    const OutlineContour mirrored =
        circleContour({-TorusSection::kRing, TorusSection::kHeight}, TorusSection::kTube);
    return {
        {"cone",
         {onBothSides({{0.0, Cone::kTop}, {Cone::kRadius, Cone::kBottom}, {0.0, Cone::kBottom}})}},
        {"torus", {ring, mirrored}},
        {"sphere", {circleContour({0.0, SphereSection::kHeight}, SphereSection::kRadius)}},
        {"vase", {vase()}}};
}

}  // namespace relievo::reference
