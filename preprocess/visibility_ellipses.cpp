#include "preprocess/visibility_ellipses.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "preprocess/horizon_map.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;

// Axes that differ by less than this are those of a circle, which has no direction.
constexpr double kRound = 1e-9;

// Integrals of 1, x, y, x², xy and y² over a part of the disk.
struct Moments {
    double area = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;

    void add(const Moments& other, double factor1, double factor3, double factor4) {
        area += factor1 * other.area;
        x += factor3 * other.x;
        y += factor3 * other.y;
        xx += factor4 * other.xx;
        xy += factor4 * other.xy;
        yy += factor4 * other.yy;
    }
};

// Those of sector `index` of `count`, of radius 1, around its azimuth.
Moments momentsOfSector(int index, int count) {
    const double azimuth = azimuthOf(index, count);
    const double half = std::numbers::pi / count;
    const double swing = std::sin(2.0 * half) / 2.0;
    return {half,
            2.0 / 3.0 * std::sin(half) * std::cos(azimuth),
            2.0 / 3.0 * std::sin(half) * std::sin(azimuth),
            (half + swing * std::cos(2.0 * azimuth)) / 4.0,
            swing * std::sin(2.0 * azimuth) / 4.0,
            (half - swing * std::cos(2.0 * azimuth)) / 4.0};
}

void setEllipse(const Moments& moments, std::size_t texel, VisibilityEllipses& ellipses) {
    const double x = moments.x / moments.area;
    const double y = moments.y / moments.area;
    const double xx = moments.xx / moments.area - x * x;
    const double xy = moments.xy / moments.area - x * y;
    const double yy = moments.yy / moments.area - y * y;
    const double mean = (xx + yy) / 2.0;
    const double spread = std::hypot((xx - yy) / 2.0, xy);
    // The second moment of an ellipse along an axis is a quarter of the squared half axis.
    ellipses.centreX.texels[texel] = static_cast<float>(x);
    ellipses.centreY.texels[texel] = static_cast<float>(y);
    ellipses.longer.texels[texel] = static_cast<float>(2.0 * std::sqrt(mean + spread));
    ellipses.shorter.texels[texel] =
        static_cast<float>(2.0 * std::sqrt(std::max(mean - spread, 0.0)));
    ellipses.angle.texels[texel] =
        spread < kRound * mean ? 0.0f : static_cast<float>(std::atan2(2.0 * xy, xx - yy) / 2.0);
}

}  // namespace

VisibilityEllipses fitVisibilityEllipses(std::span<const Plane* const> horizons,
                                         double depthScale) {
    assert(horizons.size() >= 3 && depthScale >= 0.0);
    std::vector<Moments> sectors;
    for (std::size_t k = 0; k < horizons.size(); ++k)
        sectors.push_back(momentsOfSector(static_cast<int>(k), static_cast<int>(horizons.size())));
    const Plane empty(horizons.front()->width, horizons.front()->height);
    VisibilityEllipses ellipses{empty, empty, empty, empty, empty};
    for (std::size_t texel = 0; texel < empty.texels.size(); ++texel) {
        Moments moments;
        for (std::size_t k = 0; k < horizons.size(); ++k) {
            const double tangent = depthScale * horizons[k]->texels[texel];
            const double squared = 1.0 / (1.0 + tangent * tangent);  // radius, the cosine
            moments.add(sectors[k], squared, squared * std::sqrt(squared), squared * squared);
        }
        setEllipse(moments, texel, ellipses);
    }
    return ellipses;
}

}  // namespace relievo::preprocess
