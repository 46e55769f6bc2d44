#include "coverage_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <utility>

#include "coverage_outline.h"

namespace relievo::preprocess {
namespace {

// A good fit: root mean square of the areas' differences. Of 8-bit coverage it is 0.001, of a
// circle of a radius of 10 texels 0.004.
constexpr double kGoodFit = 0.006;

struct Line {
    glm::dvec2 point{0.0};
    glm::dvec2 normal{1.0, 0.0};  // outwards
    double error = HUGE_VAL;

    [[nodiscard]] bool isGood() const { return error < kGoodFit; }
    [[nodiscard]] double side(const glm::dvec2& place) const {
        return glm::dot(normal, place - point);
    }
};

double squareOf(double x) {
    return x > 0.0 ? x * x : 0.0;
}

// Of the half plane {normal·x ≤ level} in the unit square around 0.
double halfPlaneArea(const glm::dvec2& normal, double level) {
    const double x = std::max(std::abs(normal.x), 1e-5);
    const double y = std::max(std::abs(normal.y), 1e-5);
    const double h = level + 0.5 * (x + y);
    const double area =
        (squareOf(h) - squareOf(h - x) - squareOf(h - y) + squareOf(h - x - y)) / (2.0 * x * y);
    return std::clamp(area, 0.0, 1.0);
}

double coverageAt(const textures::Plane& coverage, int i, int j) {
    const bool isIn = i >= 0 && j >= 0 && i < coverage.width && j < coverage.height;
    return isIn ? coverage.at(i, j) : 0.0;
}

using Residuals = std::array<double, 9>;

Residuals residuals(const textures::Plane& coverage, int i, int j, double angle, double level) {
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    Residuals result;
    std::size_t k = 0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            result[k++] = halfPlaneArea(normal, level - glm::dot(normal, glm::dvec2(x, y))) -
                          coverageAt(coverage, i + x, j + y);
    return result;
}

double sumOfSquares(const Residuals& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value * value;
    return sum;
}

// Gauss and Newton, with steps that get shorter where they make it worse.
Line fitLine(const textures::Plane& coverage, int i, int j) {
    glm::dvec2 out(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const double weight = (x == 0 ? 2.0 : 1.0) * (y == 0 ? 2.0 : 1.0);
            out -= weight * coverageAt(coverage, i + x, j + y) * glm::dvec2(x, y);
        }
    if (!(glm::dot(out, out) > 0.0))
        return {};
    double angle = std::atan2(out.y, out.x);
    double level = coverageAt(coverage, i, j) - 0.5;
    Residuals now = residuals(coverage, i, j, angle, level);
    for (int step = 0; step < 12; ++step) {
        constexpr double kSmall = 1e-6;
        const Residuals turned = residuals(coverage, i, j, angle + kSmall, level);
        const Residuals moved = residuals(coverage, i, j, angle, level + kSmall);
        double aa = 1e-12;
        double ab = 0.0;
        double bb = 1e-12;
        double a = 0.0;
        double b = 0.0;
        for (std::size_t k = 0; k < now.size(); ++k) {
            const double byAngle = (turned[k] - now[k]) / kSmall;
            const double byLevel = (moved[k] - now[k]) / kSmall;
            aa += byAngle * byAngle;
            ab += byAngle * byLevel;
            bb += byLevel * byLevel;
            a += byAngle * now[k];
            b += byLevel * now[k];
        }
        const double determinant = aa * bb - ab * ab;
        if (!(determinant > 1e-15))
            break;
        double share = 1.0;
        for (; share > 1e-3; share *= 0.5) {
            const double nextAngle = angle - share * (bb * a - ab * b) / determinant;
            const double nextLevel = level - share * (aa * b - ab * a) / determinant;
            const Residuals next = residuals(coverage, i, j, nextAngle, nextLevel);
            if (sumOfSquares(next) >= sumOfSquares(now))
                continue;
            angle = nextAngle;
            level = nextLevel;
            now = next;
            break;
        }
        if (share <= 1e-3)
            break;
    }
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    return {glm::dvec2(i + 0.5, j + 0.5) + level * normal, normal,
            std::sqrt(sumOfSquares(now) / 9.0)};
}

// The lines of the texels next to the half level.
class Lines {
  public:
    explicit Lines(const textures::Plane& coverage) : coverage_(coverage) {}

    // The line of the nearest texel around with a good fit which passes through that texel's
    // square, or just beside it, and near `place`.
    [[nodiscard]] std::optional<Line> at(const glm::dvec2& place) {
        const int x = static_cast<int>(std::floor(place.x));
        const int y = static_cast<int>(std::floor(place.y));
        std::optional<Line> best;
        double nearest = HUGE_VAL;
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i) {
                const double distance = glm::distance(place, glm::dvec2(i + 0.5, j + 0.5));
                if (distance > 0.9 || distance >= nearest)
                    continue;
                const Line& line = fitted(i, j);
                if (!line.isGood() || std::abs(line.side(place)) > 0.3)
                    continue;
                nearest = distance;
                best = line;
            }
        return best;
    }

  private:
    const Line& fitted(int i, int j) {
        const auto [entry, isNew] = lines_.try_emplace({i, j});
        if (isNew)
            entry->second = fitLine(coverage_, i, j);
        return entry->second;
    }
    const textures::Plane& coverage_;
    std::map<std::pair<int, int>, Line> lines_;
};

// Segments as closed contours.
std::vector<reference::OutlineContour> chained(const std::vector<BoundarySegment>& segments) {
    const auto key = [](const glm::dvec2& place) {
        return std::pair(std::llround(place.x * 1e7), std::llround(place.y * 1e7));
    };
    std::map<std::pair<long long, long long>, std::vector<std::size_t>> ends;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        ends[key(segments[k].start)].push_back(k);
        ends[key(segments[k].end)].push_back(k);
    }
    std::vector<bool> isUsed(segments.size());
    std::vector<reference::OutlineContour> contours;
    for (std::size_t first = 0; first < segments.size(); ++first) {
        if (isUsed[first])
            continue;
        reference::OutlineContour contour;
        std::size_t k = first;
        glm::dvec2 place = segments[first].start;
        while (true) {
            isUsed[k] = true;
            contour.push_back(place);
            place = key(segments[k].start) == key(place) ? segments[k].end : segments[k].start;
            const std::vector<std::size_t>& next = ends[key(place)];
            const auto free =
                std::find_if(next.begin(), next.end(), [&](std::size_t n) { return !isUsed[n]; });
            if (free == next.end())
                break;
            k = *free;
        }
        contours.push_back(contour);
    }
    return contours;
}

std::optional<glm::dvec2> meeting(const Line& a, const Line& b) {
    const double determinant = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
    if (std::abs(determinant) < 0.08)  // less than 5° between them
        return std::nullopt;
    const double p = glm::dot(a.normal, a.point);
    const double q = glm::dot(b.normal, b.point);
    return glm::dvec2(p * b.normal.y - q * a.normal.y, q * a.normal.x - p * b.normal.x) /
           determinant;
}

constexpr double kFurthestCorner = 4.0;  // texels from the vertices that it stands for

double nearestOf(const reference::OutlineContour& contour, std::size_t first, std::size_t count,
                 const glm::dvec2& place) {
    double nearest = HUGE_VAL;
    for (std::size_t k = 0; k < count; ++k)
        nearest = std::min(nearest, glm::distance(place, contour[(first + k) % contour.size()]));
    return nearest;
}

// What of a texel the corner of two half planes covers: of both, or of either. By 64 points, which
// is right to a few hundredths.
double cornerArea(const Line& a, const Line& b, bool isConvex, const glm::dvec2& middle) {
    constexpr int kPoints = 8;
    int count = 0;
    for (int y = 0; y < kPoints; ++y)
        for (int x = 0; x < kPoints; ++x) {
            const glm::dvec2 place =
                middle + (glm::dvec2(x, y) + 0.5) / static_cast<double>(kPoints) - 0.5;
            const bool isInA = a.side(place) <= 0.0;
            const bool isInB = b.side(place) <= 0.0;
            count += (isConvex ? isInA && isInB : isInA || isInB) ? 1 : 0;
        }
    return static_cast<double>(count) / (kPoints * kPoints);
}

constexpr double kCornerMismatch = 0.08;

// Whether the corner of two lines covers what the bitmap says of the texels around the vertices.
bool explains(const textures::Plane& coverage, const Line& a, const Line& b,
              const reference::OutlineContour& contour, std::size_t first, std::size_t count) {
    double convex = 0.0;
    double reflex = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        const glm::dvec2& vertex = contour[(first + k) % contour.size()];
        const int x = static_cast<int>(std::floor(vertex.x));
        const int y = static_cast<int>(std::floor(vertex.y));
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i) {
                const glm::dvec2 middle(i + 0.5, j + 0.5);
                const double area = coverageAt(coverage, i, j);
                convex = std::max(convex, std::abs(cornerArea(a, b, true, middle) - area));
                reflex = std::max(reflex, std::abs(cornerArea(a, b, false, middle) - area));
            }
    }
    return std::min(convex, reflex) < kCornerMismatch;
}

void appendSharpened(const textures::Plane& coverage, const reference::OutlineContour& contour,
                     Lines& lines, FittedOutline& outline) {
    LineStatistics& statistics = outline.statistics;
    reference::OutlineContour& result = outline.contours.emplace_back();
    const std::size_t size = contour.size();
    std::vector<std::optional<Line>> at;
    for (const glm::dvec2& place : contour)
        at.push_back(lines.at(place));
    const auto start = static_cast<std::size_t>(
        std::find_if(at.begin(), at.end(), [](const auto& l) { return l.has_value(); }) -
        at.begin());
    statistics.vertices += static_cast<int>(size);
    if (start == size) {
        statistics.left += static_cast<int>(size);
        result = contour;
        return;
    }
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t number = (start + k) % size;
        if (at[number]) {
            const Line& line = *at[number];
            result.push_back(contour[number] - line.side(contour[number]) * line.normal);
            ++statistics.onLines;
            continue;
        }
        std::size_t count = 1;
        while (k + count < size && !at[(start + k + count) % size])
            ++count;
        const Line& before = *at[(number + size - 1) % size];
        const Line& behind = *at[(number + count) % size];
        const std::optional<glm::dvec2> corner = meeting(before, behind);
        if (corner && nearestOf(contour, number, count, *corner) < kFurthestCorner &&
            explains(coverage, before, behind, contour, number, count)) {
            outline.corners.push_back({outline.contours.size() - 1, result.size(), *corner});
            result.push_back(*corner);
            ++statistics.corners;
        } else {
            for (std::size_t n = 0; n < count; ++n)
                result.push_back(contour[(number + n) % size]);
            statistics.left += static_cast<int>(count);
        }
        k += count - 1;
    }
}

}  // namespace

FittedOutline fittedOutline(const textures::Plane& coverage) {
    Lines lines(coverage);
    FittedOutline outline;
    for (const reference::OutlineContour& contour : chained(halfLevel(coverage)))
        appendSharpened(coverage, contour, lines, outline);
    return outline;
}

}  // namespace relievo::preprocess
