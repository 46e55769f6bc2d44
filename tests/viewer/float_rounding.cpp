#include "float_rounding.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "shaders/relievo/constants.h"

namespace relievo::viewer {
namespace {

double steepestStep(const textures::DepthMap& map) {
    float steepest = 0.0f;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i)
            steepest = std::max({steepest, std::abs(map.at(i + 1, j) - map.at(i, j)),
                                 std::abs(map.at(i, j + 1) - map.at(i, j))});
    return static_cast<double>(steepest);
}

// A product of t and a speed in texels rounds by 2⁻²⁴ of the texels that the ray has gone, and so
// do t itself and the sum with the start: a quarter of 2⁻²⁰ in all, along both axes; and as much of
// a texel for the fraction. The place of the start within two tiles, in texels, rounds by 2⁻²⁴ of
// those, but for powers of two, which round nothing. On the steepest slope of the map that is as
// much depth as the ray may seem higher or lower than it is; depths themselves, of at most 1, take
// eight roundings more.
struct Rounding {
    double texels;
    double depth;
};

Rounding roundingAt(double texelsGone, const textures::DepthMap& map, double steepest) {
    const auto startRounding = [](int size) {
        return std::has_single_bit(static_cast<unsigned>(size)) ? 0.0 : 0x1p-23 * size;
    };
    const double texels =
        0x1p-22 * (texelsGone + 1.0) + startRounding(map.width()) + startRounding(map.height());
    return {texels, texels * steepest + 0x1p-21};
}

}  // namespace

FloatRounding::FloatRounding(const textures::DepthMap& map)
    : map_(map), steepest_(steepestStep(map)) {}

double FloatRounding::meets(reference::TileRay ray, double lower) const {
    ray.origin.z -= lower;
    constexpr double kReach = RELIEVO_MAXIMUM_REACH * (1.0 + 0x1p-20);
    const auto hit = reference::traceBilinear(map_, ray, {}, kReach);
    return hit ? hit->t : std::numeric_limits<double>::infinity();
}

bool FloatRounding::explains(const MeasuredPixel& pixel) const {
    if (pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED)
        return false;
    const reference::TileRay ray{glm::dvec3(pixel.origin), glm::dvec3(pixel.direction)};
    const double t = pixel.t;
    const double speed =
        std::hypot(map_.width() * ray.direction.x, map_.height() * ray.direction.y);
    const Rounding rounding = roundingAt(t * speed, map_, steepest_);
    const double slack = (1.0 + t) * 0x1p-22 + rounding.texels / std::max(speed, 1.0);
    if (t > meets(ray, rounding.depth) + slack)
        return false;
    return pixel.outcome == RELIEVO_OUTCOME_MISS || t >= meets(ray, -rounding.depth) - slack;
}

}  // namespace relievo::viewer
