#include "reference/error_metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>
#include <vector>

namespace relievo::reference {

namespace {

/// In degrees. The arc cosine of the dot product would lose all angles under 1e-6 degrees.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The smallest value that at least 99 % of `values` do not exceed. Reorders them.
double percentile99(std::vector<double>& values) {
    const std::size_t rank = (values.size() * 99 + 99) / 100;
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
}

}  // namespace

ErrorStatistics summarizeErrors(std::span<const HitComparison> comparisons, double tolerance) {
    assert(tolerance >= 0.0);
    ErrorStatistics result;
    result.rays = comparisons.size();
    if (comparisons.empty())
        return result;
    std::size_t wrong = 0;
    std::size_t unconverged = 0;
    std::size_t overshot = 0;
    std::vector<double> distances;
    std::vector<double> angles;
    for (const HitComparison& ray : comparisons) {
        bool right = ray.converged && ray.found == ray.exists;
        unconverged += ray.converged ? 0 : 1;
        if (ray.found && ray.exists) {
            const double error = ray.distance - ray.exactDistance;
            const double angle = angleBetween(ray.normal, ray.exactNormal);
            right = right && std::abs(error) <= tolerance && std::isfinite(angle);
            if (std::isfinite(error) && std::isfinite(angle)) {
                overshot += error > tolerance ? 1 : 0;
                distances.push_back(std::abs(error));
                angles.push_back(angle);
            }
        }
        wrong += right ? 0 : 1;
    }
    const auto rays = static_cast<double>(comparisons.size());
    result.compared = distances.size();
    result.wrongShare = static_cast<double>(wrong) / rays;
    result.unconvergedShare = static_cast<double>(unconverged) / rays;
    result.overshotShare = static_cast<double>(overshot) / rays;
    if (distances.empty())
        return result;
    result.meanDistance = mean(distances);
    result.maximumDistance = *std::max_element(distances.begin(), distances.end());
    result.percentile99Distance = percentile99(distances);
    result.meanNormalAngle = mean(angles);
    result.percentile99NormalAngle = percentile99(angles);
    return result;
}

}  // namespace relievo::reference
