#include "outlines/curve_flattening.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace relievo::outlines {
namespace {

// Chords of a curve that is no longer than what memory holds, whatever the tolerance.
constexpr double kMostChords = 65536.0;

template <std::size_t Count>
glm::dvec2 pointAt(std::array<glm::dvec2, Count> points, double t) {
    // De Casteljau: in one place, and no power of t is formed.
    for (std::size_t last = Count - 1; last > 0; --last)
        for (std::size_t k = 0; k < last; ++k)
            points[k] += t * (points[k + 1] - points[k]);
    return points[0];
}

template <std::size_t Count>
void append(const std::array<glm::dvec2, Count>& points, double tolerance, Contour& contour) {
    assert(tolerance > 0.0);
    constexpr double kDegree = Count - 1;
    double bend = 0.0;
    for (std::size_t k = 0; k + 2 < Count; ++k)
        bend = std::max(bend, glm::length(points[k + 2] - 2.0 * points[k + 1] + points[k]));
    const double chords = std::sqrt(kDegree * (kDegree - 1.0) * bend / (8.0 * tolerance));
    const int count = static_cast<int>(std::ceil(std::clamp(chords, 1.0, kMostChords)));
    for (int k = 1; k < count; ++k)
        contour.push_back(pointAt(points, static_cast<double>(k) / count));
    contour.push_back(points[Count - 1]);
}

}  // namespace

void appendQuadratic(const std::array<glm::dvec2, 3>& points, double tolerance, Contour& contour) {
    append(points, tolerance, contour);
}

void appendCubic(const std::array<glm::dvec2, 4>& points, double tolerance, Contour& contour) {
    append(points, tolerance, contour);
}

}  // namespace relievo::outlines
