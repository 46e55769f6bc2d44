#include "solids/tile_metric.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace relievo::solids {
namespace {

// Bounds are to hold in spite of rounding.
constexpr double kSafety = 1.0 - 1e-12;

// The smaller eigenvalue of a symmetric 2×2 matrix that is positive definite; through the larger
// one, as the difference would cancel.
double smallerEigenvalue(double a, double b, double c) {
    const double larger = 0.5 * (a + c) + std::hypot(0.5 * (a - c), b);
    return larger > 0.0 ? std::max(0.0, (a * c - b * b) / larger) : 0.0;
}

// 1/√Σ aᵢⱼ² of the inverse: no vector is shortened by more than that.
double leastStretch(const glm::dmat3& m) {
    const glm::dmat3 inverse = glm::inverse(m);
    return 1.0 / std::sqrt(glm::dot(inverse[0], inverse[0]) + glm::dot(inverse[1], inverse[1]) +
                           glm::dot(inverse[2], inverse[2]));
}

}  // namespace

TileMetric tileMetric(const glm::dmat3& world, double rowScale) {
    glm::dmat3 square = world;
    square[1] /= rowScale;
    const double level =
        smallerEigenvalue(glm::dot(square[0], square[0]), glm::dot(square[0], square[1]),
                          glm::dot(square[1], square[1]));
    const double upright = glm::dot(square[2], square[2]);
    // 2·g·h·z ≥ −κ·(level·h² + upright·z²) for the mixed terms g of a placement that leans.
    const double mixed = std::hypot(glm::dot(square[0], square[2]), glm::dot(square[1], square[2]));
    const double lean = mixed > 0.0 ? mixed / std::sqrt(level * upright) : 0.0;
    TileMetric metric;
    const double kept = std::sqrt(std::max(0.0, 1.0 - lean));
    metric.horizontal = kSafety * kept * std::sqrt(level);
    metric.vertical = kSafety * kept * std::sqrt(upright);
    const double least = kSafety * leastStretch(square);
    if (!(std::min(metric.horizontal, metric.vertical) >= least))
        metric.horizontal = metric.vertical = least;
    const glm::dmat3 rows = glm::transpose(glm::inverse(world));
    for (int axis = 0; axis < 3; ++axis)
        metric.slab[axis] = kSafety / glm::length(rows[axis]);
    return metric;
}

}  // namespace relievo::solids
