#include "coverage_outline.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relievo::preprocess {
namespace {

// Calls visit(from, to) for the parts of [0,1] between the whole numbers that start + t·step
// passes.
template <class Visit>
void visitParts(double start, double step, const Visit& visit) {
    const double end = start + step;
    double from = 0.0;
    if (step != 0.0) {
        const double low = std::floor(std::min(start, end)) + 1.0;
        const double high = std::ceil(std::max(start, end)) - 1.0;
        const int count = static_cast<int>(high - low) + 1;
        for (int k = 0; k < count; ++k) {
            const double whole = step > 0.0 ? low + k : high - k;
            const double to = std::clamp((whole - start) / step, from, 1.0);
            visit(from, to);
            from = to;
        }
    }
    visit(from, 1.0);
}

}  // namespace

textures::Plane coverageOf(const PlaneShape& shape, int width, int height, int levels) {
    // What an edge adds to its texel, and to all texels to its right.
    std::vector<double> own(static_cast<std::size_t>(width) * height);
    std::vector<double> right(own.size());
    for (const BoundarySegment& edge : shape.edges) {
        const glm::dvec2 along = edge.end - edge.start;
        visitParts(edge.start.y, along.y, [&](double top, double bottom) {
            const glm::dvec2 start = edge.start + top * along;
            const glm::dvec2 step = (bottom - top) * along;
            visitParts(start.x, step.x, [&](double from, double to) {
                const glm::dvec2 middle = start + 0.5 * (from + to) * step;
                const int i = std::clamp(static_cast<int>(std::floor(middle.x)), 0, width - 1);
                const int j = std::clamp(static_cast<int>(std::floor(middle.y)), 0, height - 1);
                const std::size_t k = static_cast<std::size_t>(j) * width + i;
                const double rise = (to - from) * step.y;
                own[k] += rise * (1.0 - (middle.x - i));
                right[k] += rise;
            });
        });
    }
    textures::Plane coverage(width, height);
    for (int j = 0; j < height; ++j) {
        double sum = 0.0;
        for (int i = 0; i < width; ++i) {
            const std::size_t k = static_cast<std::size_t>(j) * width + i;
            const double area = std::clamp(std::abs(sum + own[k]), 0.0, 1.0);
            coverage.texels[k] =
                static_cast<float>(levels > 0 ? std::round(area * levels) / levels : area);
            sum += right[k];
        }
    }
    return coverage;
}

std::vector<BoundarySegment> halfLevel(const textures::Plane& coverage) {
    const auto at = [&](int i, int j) {
        const bool isIn = i >= 0 && j >= 0 && i < coverage.width && j < coverage.height;
        return isIn ? static_cast<double>(coverage.at(i, j)) - 0.5 : -0.5;
    };
    std::vector<BoundarySegment> segments;
    for (int j = -1; j < coverage.height; ++j)
        for (int i = -1; i < coverage.width; ++i) {
            // Around the cell; crossings of its sides in that order.
            const std::array<glm::dvec2, 4> places{
                {{i + 0.5, j + 0.5}, {i + 1.5, j + 0.5}, {i + 1.5, j + 1.5}, {i + 0.5, j + 1.5}}};
            const std::array<double, 4> values{at(i, j), at(i + 1, j), at(i + 1, j + 1),
                                               at(i, j + 1)};
            std::array<glm::dvec2, 4> crossings;
            std::size_t count = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t next = (k + 1) % 4;
                if ((values[k] >= 0.0) == (values[next] >= 0.0))
                    continue;
                const double share = values[k] / (values[k] - values[next]);
                crossings[count++] = places[k] + share * (places[next] - places[k]);
            }
            if (count == 2)
                segments.push_back({crossings[0], crossings[1]});
            if (count == 4) {
                // The crossing of the hyperbola's axes tells which two belong together.
                const double saddle = values[0] * values[2] - values[1] * values[3];
                const double sum = values[0] + values[2] - values[1] - values[3];
                const bool isFirstJoined = (saddle / sum >= 0.0) == (values[0] >= 0.0);
                const std::size_t shift = isFirstJoined ? 0 : 1;
                segments.push_back({crossings[shift], crossings[shift + 1]});
                segments.push_back({crossings[shift + 2], crossings[(shift + 3) % 4]});
            }
        }
    return segments;
}

}  // namespace relievo::preprocess
