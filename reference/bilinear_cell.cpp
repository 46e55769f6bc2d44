#include "reference/bilinear_cell.h"

#include <algorithm>
#include <cmath>

#include "reference/difference_of_products.h"

namespace relievo::reference {

BilinearCell::BilinearCell(double d00, double d10, double d01, double d11) noexcept
    : corner(d00),
      slope(d10 - d00, d01 - d00),
      twist((d11 - d01) - (d10 - d00)),
      minimum(std::min({d00, d10, d01, d11})) {}

DepthBelowSurface depthBelowSurface(const BilinearCell& cell, const glm::dvec3& from,
                                    const glm::dvec3& direction) noexcept {
    const glm::dvec2 p(from);
    const glm::dvec2 gradient = cell.gradient(p);
    return {from.z - cell.depth(p),
            direction.z - gradient.x * direction.x - gradient.y * direction.y,
            -cell.twist * direction.x * direction.y};
}

std::optional<double> firstCrossing(const DepthBelowSurface& below) noexcept {
    const auto [q0, q1, q2] = below;
    if (q0 >= 0.0)
        return 0.0;
    const double discriminant = differenceOfProducts(q1, q1, 4.0 * q2, q0);
    if (discriminant < 0.0)
        return std::nullopt;
    // With q0 < 0 the first positive root has a form without cancellation for either sign of q1.
    const double root = std::sqrt(discriminant);
    if (q1 >= 0.0)
        return q1 + root > 0.0 ? std::optional(-2.0 * q0 / (q1 + root)) : std::nullopt;
    return q2 > 0.0 ? std::optional((root - q1) / (2.0 * q2)) : std::nullopt;
}

}  // namespace relievo::reference
