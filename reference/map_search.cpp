#include "reference/map_search.h"

#include <cmath>

#include "reference/bilinear_cell.h"

namespace relievo::reference {

double DescendingRay::speed(double aspect) const noexcept {
    return std::hypot(slope.x, aspect * slope.y);
}

DescendingRay descendingRay(const glm::dvec2& start, double elevation, double azimuth,
                            double depthScale, double aspect) {
    const double speed = depthScale / std::tan(elevation);
    return {start, {speed * std::cos(azimuth), speed * std::sin(azimuth) / aspect}};
}

CellWalk walkOver(const textures::DepthMap& relief, const DescendingRay& ray) {
    return {relief, {ray.start, 0.0}, {ray.slope, 1.0}, 1.0};
}

std::optional<double> hitInCell(const CellWalk& walk) {
    const std::optional<double> s = firstCrossing(walk.below(walk.surface()));
    if (!s || walk.entry() + *s > walk.exit())
        return std::nullopt;
    return walk.entry() + *s;
}

}  // namespace relievo::reference
