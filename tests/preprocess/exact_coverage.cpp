#include "exact_coverage.h"

#include <algorithm>
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

}  // namespace relievo::preprocess
