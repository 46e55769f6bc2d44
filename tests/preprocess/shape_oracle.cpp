#include "tests/preprocess/shape_oracle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace relievo::preprocess {
namespace {

using Polygon = std::vector<glm::dvec2>;

constexpr double kPi = std::numbers::pi;

Polygon around(const glm::dvec2& centre, int corners, double angle,
               const std::vector<double>& radii) {
    Polygon polygon;
    for (int k = 0; k < corners; ++k) {
        const double direction = angle + 2.0 * kPi * k / corners;
        polygon.push_back(centre + radii[static_cast<std::size_t>(k) % radii.size()] *
                                       glm::dvec2(std::cos(direction), std::sin(direction)));
    }
    return polygon;
}

// The part where sign·(place[axis] − limit) ≤ 0.
Polygon clipped(const Polygon& polygon, int axis, double limit, double sign) {
    Polygon result;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const glm::dvec2& a = polygon[k];
        const glm::dvec2& b = polygon[(k + 1) % polygon.size()];
        const double atA = sign * (a[axis] - limit);
        const double atB = sign * (b[axis] - limit);
        if (atA <= 0.0)
            result.push_back(a);
        if ((atA < 0.0 && atB > 0.0) || (atA > 0.0 && atB < 0.0))
            result.push_back(a + atA / (atA - atB) * (b - a));
    }
    return result;
}

double areaOf(const Polygon& polygon) {
    double doubled = 0.0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const glm::dvec2 a = polygon[k] - polygon[0];
        const glm::dvec2 b = polygon[(k + 1) % polygon.size()] - polygon[0];
        doubled += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(doubled);
}

double segmentDistance(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& place) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double share =
        square > 0.0 ? std::clamp(glm::dot(place - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(place, a + share * along);
}

}  // namespace

Polygons discOf(const glm::dvec2& centre, double radius) {
    return {around(centre, 2000, 0.1, {radius})};
}

Polygons annulusOf(const glm::dvec2& centre, double inner, double outer) {
    return {around(centre, 2000, 0.1, {outer}), around(centre, 2000, 0.3, {inner})};
}

Polygons squareOf(const glm::dvec2& centre, double halfSide, double angle) {
    return {around(centre, 4, angle + 0.25 * kPi, {std::sqrt(2.0) * halfSide})};
}

Polygons starOf(const glm::dvec2& centre, double inner, double outer, int points, double angle) {
    return {around(centre, 2 * points, angle, {outer, inner})};
}

outlines::Drawing drawingOf(const Polygons& shape, int width, int height) {
    outlines::Outline outline{{}, outlines::FillRule::EvenOdd};
    for (const Polygon& polygon : shape) {
        outlines::Contour& contour = outline.contours.emplace_back();
        for (const glm::dvec2& corner : polygon)
            contour.push_back(corner / static_cast<double>(width));
    }
    return {{outline}, static_cast<double>(height) / width};
}

textures::Plane exactCoverage(const Polygons& shape, int width, int height) {
    textures::Plane coverage(width, height);
    for (int j = 0; j < height; ++j) {
        Polygons row;
        for (const Polygon& polygon : shape)
            row.push_back(clipped(clipped(polygon, 1, j, -1.0), 1, j + 1, 1.0));
        for (int i = 0; i < width; ++i) {
            double covered = 0.0;
            // Polygons within each other: the largest counts, the hole in it does not, …
            double sign = 1.0;
            for (const Polygon& polygon : row) {
                covered += sign * areaOf(clipped(clipped(polygon, 0, i, -1.0), 0, i + 1, 1.0));
                sign = -sign;
            }
            coverage.at(i, j) = static_cast<float>(std::clamp(covered, 0.0, 1.0));
        }
    }
    return coverage;
}

double signedDistance(const Polygons& shape, const glm::dvec2& place) {
    double nearest = HUGE_VAL;
    bool inside = false;
    for (const Polygon& polygon : shape)
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const glm::dvec2& a = polygon[k];
            const glm::dvec2& b = polygon[(k + 1) % polygon.size()];
            nearest = std::min(nearest, segmentDistance(a, b, place));
            if ((a.y <= place.y) != (b.y <= place.y) &&
                place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
    return inside ? -nearest : nearest;
}

double cornerDistance(const Polygons& shape, const glm::dvec2& place) {
    double nearest = HUGE_VAL;
    for (const Polygon& polygon : shape)
        for (const glm::dvec2& corner : polygon)
            nearest = std::min(nearest, glm::distance(corner, place));
    return nearest;
}

}  // namespace relievo::preprocess
