#include "outline_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <unordered_map>

namespace relievo::preprocess {
namespace {

float clampedAt(const textures::Plane& plane, int i, int j) {
    return plane.at(std::clamp(i, 0, plane.width - 1), std::clamp(j, 0, plane.height - 1));
}

std::array<double, 4> clampedSamples(const textures::Plane& plane, int i, int j) {
    return {clampedAt(plane, i, j), clampedAt(plane, i + 1, j), clampedAt(plane, i, j + 1),
            clampedAt(plane, i + 1, j + 1)};
}

reference::ShapeCell cellOf(const SampledDistance& field, int i, int j) {
    return reference::shapeCell(
        clampedSamples(field.distance, i, j),
        field.hasCrease() ? clampedSamples(field.crease, i, j) : std::array<double, 4>{}, 1.0);
}

double inCell(const SampledDistance& field, int i, int j, const glm::dvec2& part) {
    return cellOf(field, i, j).distance(part);
}

// Where the cell's f is 0 on the line from a to b (parts of the cell), which is parallel to an
// axis.
void findZeros(const SampledDistance& field, int i, int j, const glm::dvec2& a, const glm::dvec2& b,
               std::vector<glm::dvec2>& points) {
    std::array<double, 2> breaks{0.0, 1.0};
    int count = 1;
    const reference::ShapeCell cell = cellOf(field, i, j);
    if (cell.isCreased()) {
        const double start = cell.a.depth(a) - cell.b.depth(a);
        const double end = cell.a.depth(b) - cell.b.depth(b);
        const double t = start / (start - end);
        if (t > 0.0 && t < 1.0)
            breaks[static_cast<std::size_t>(count++)] = t;
    }
    for (int k = 0; k < count; ++k) {
        const double from = breaks[static_cast<std::size_t>(k)];
        const double to = k + 1 < count ? breaks[static_cast<std::size_t>(k + 1)] : 1.0;
        const double start = cell.distance(a + from * (b - a));
        const double end = cell.distance(a + to * (b - a));
        if ((start <= 0.0) == (end <= 0.0))
            continue;
        const double t = from + (to - from) * start / (start - end);
        points.push_back(glm::dvec2(i + 0.5, j + 0.5) + a + t * (b - a));
    }
}

bool mayHaveZero(const SampledDistance& field, int i, int j) {
    if (field.hasCrease())
        return std::abs(inCell(field, i, j, glm::dvec2(0.5))) < 3.0;
    const double first = clampedAt(field.distance, i, j);
    for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {1, 1}})
        if ((clampedAt(field.distance, i + x, j + y) <= 0.0) != (first <= 0.0))
            return true;
    return false;
}

// Points in squares of a texel, for the nearest of them within a texel or two.
class PointGrid {
  public:
    explicit PointGrid(const std::vector<glm::dvec2>& points) {
        for (const glm::dvec2& point : points)
            squares_[key(static_cast<int>(std::floor(point.x)),
                         static_cast<int>(std::floor(point.y)))]
                .push_back(point);
    }
    [[nodiscard]] double nearest(const glm::dvec2& place) const {
        const int x = static_cast<int>(std::floor(place.x));
        const int y = static_cast<int>(std::floor(place.y));
        double nearest = kFar;
        for (int radius = 0; radius <= kRadius && nearest > radius - 1; ++radius)
            for (int j = -radius; j <= radius; ++j)
                for (int i = -radius; i <= radius; ++i)
                    if (std::max(std::abs(i), std::abs(j)) == radius)
                        nearest = std::min(nearest, nearestIn(x + i, y + j, place));
        return nearest;
    }

  private:
    static constexpr int kRadius = 8;
    static constexpr double kFar = 1e3;

    static std::uint64_t key(int x, int y) {
        return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
               static_cast<std::uint32_t>(y);
    }
    [[nodiscard]] double nearestIn(int x, int y, const glm::dvec2& place) const {
        const auto square = squares_.find(key(x, y));
        double nearest = kFar;
        if (square != squares_.end())
            for (const glm::dvec2& point : square->second)
                nearest = std::min(nearest, glm::distance(point, place));
        return nearest;
    }

    std::unordered_map<std::uint64_t, std::vector<glm::dvec2>> squares_;
};

// Every 1/8 texel, and the vertices.
template <class Visit>
void visitOutline(const std::vector<reference::OutlineContour>& contours, const Visit& visit) {
    for (const reference::OutlineContour& contour : contours) {
        double left = 0.0;
        for (std::size_t k = 0; k < contour.size(); ++k) {
            const glm::dvec2 start = contour[k];
            const glm::dvec2 along = contour[(k + 1) % contour.size()] - start;
            const double length = glm::length(along);
            if (length > 1.0)
                visit(start);
            for (; left < length; left += 1.0 / 8.0)
                visit(start + left / length * along);
            left -= length;
        }
    }
}

// To a point of the zero level that Newton's steps lead to from `place`; far if they do not.
double distanceByNewton(const SampledDistance& field, const glm::dvec2& place) {
    constexpr double kStep = 1e-5;
    glm::dvec2 at = place;
    for (int k = 0; k < 4; ++k) {
        const double value = field.at(at);
        if (std::abs(value) < 1e-9)
            return glm::distance(at, place);
        const glm::dvec2 x(kStep, 0.0);
        const glm::dvec2 y(0.0, kStep);
        const glm::dvec2 slope =
            glm::dvec2(field.at(at + x) - field.at(at - x), field.at(at + y) - field.at(at - y)) /
            (2.0 * kStep);
        const double square = glm::dot(slope, slope);
        if (!(square > 1e-6))
            break;
        at -= value / square * slope;
    }
    return std::abs(field.at(at)) < 1e-6 ? glm::distance(at, place) : HUGE_VAL;
}

}  // namespace

double SampledDistance::at(const glm::dvec2& place) const {
    const int i = static_cast<int>(std::floor(place.x - 0.5));
    const int j = static_cast<int>(std::floor(place.y - 0.5));
    return inCell(*this, i, j, place - glm::dvec2(i + 0.5, j + 0.5));
}

double SampledDistance::sample(int i, int j) const {
    return inCell(*this, i, j, glm::dvec2(0.0));
}

std::vector<glm::dvec2> zeroLevel(const SampledDistance& field, int lines, const glm::ivec2& low,
                                  const glm::ivec2& high) {
    std::vector<glm::dvec2> points;
    for (int j = low.y; j < high.y; ++j)
        for (int i = low.x; i < high.x; ++i) {
            if (!mayHaveZero(field, i, j))
                continue;
            for (int line = 0; line < lines; ++line) {
                const double part = (line + 0.5) / lines;
                findZeros(field, i, j, {0.0, part}, {1.0, part}, points);
                findZeros(field, i, j, {part, 0.0}, {part, 1.0}, points);
            }
        }
    return points;
}

ErrorSummary summaryOf(std::vector<double> errors) {
    ErrorSummary summary;
    summary.count = errors.size();
    if (errors.empty())
        return summary;
    std::sort(errors.begin(), errors.end());
    summary.largest = errors.back();
    summary.permille = errors[(errors.size() - 1) * 999 / 1000];
    for (const double error : errors)
        summary.mean += error / static_cast<double>(errors.size());
    return summary;
}

double OutlineErrors::away() const {
    return std::max(levelAway.largest, outlineAway.largest);
}

double OutlineErrors::atCorners() const {
    return std::max(levelAtCorners.largest, outlineAtCorners.largest);
}

std::vector<ContourCorner> cornersOf(const std::vector<reference::OutlineContour>& contours) {
    const double most = std::cos(5.0 * std::numbers::pi / 180.0);
    std::vector<ContourCorner> corners;
    for (std::size_t c = 0; c < contours.size(); ++c) {
        const reference::OutlineContour& contour = contours[c];
        for (std::size_t k = 0; k < contour.size(); ++k) {
            const glm::dvec2 before =
                contour[k] - contour[(k + contour.size() - 1) % contour.size()];
            const glm::dvec2 after = contour[(k + 1) % contour.size()] - contour[k];
            if (glm::dot(before, after) < most * glm::length(before) * glm::length(after))
                corners.push_back({c, k, contour[k]});
        }
    }
    return corners;
}

OutlineErrors measureErrors(const SampledDistance& field,
                            const std::vector<reference::OutlineContour>& contours,
                            const reference::PlaneOutline& outline, const glm::ivec2& low,
                            const glm::ivec2& high, int lines) {
    constexpr double kCornerReach = 2.0;
    std::vector<glm::dvec2> cornerPlaces;
    for (const ContourCorner& corner : cornersOf(contours))
        cornerPlaces.push_back(corner.place);
    const PointGrid corners(cornerPlaces);
    const auto isAtCorner = [&](const glm::dvec2& p) { return corners.nearest(p) < kCornerReach; };
    const auto counts = [&](const glm::dvec2& p) {
        return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y;
    };
    std::array<std::vector<double>, 4> errors;
    const std::vector<glm::dvec2> level =
        zeroLevel(field, lines, low - glm::ivec2(2), high + glm::ivec2(2));
    for (const glm::dvec2& point : level)
        if (counts(point))
            errors[isAtCorner(point) ? 1 : 0].push_back(std::abs(outline.distance(point)));
    const PointGrid levelGrid(level);
    visitOutline(contours, [&](const glm::dvec2& point) {
        if (counts(point))
            errors[isAtCorner(point) ? 3 : 2].push_back(
                std::min(levelGrid.nearest(point), distanceByNewton(field, point)));
    });
    return {summaryOf(errors[0]), summaryOf(errors[1]), summaryOf(errors[2]), summaryOf(errors[3])};
}

}  // namespace relievo::preprocess
