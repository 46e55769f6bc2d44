#include "preprocess/lower_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo::preprocess {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// The largest float that is not above `value`. The slopes of a plane are rounded first, and its
// base is lowered to what the rounded slopes need, so that the stored plane is below the surface.
float floatBelow(double value) {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) > value ? std::nextafter(nearest, -kInfinity) : nearest;
}

double meanDifference(float a, float b, float c, float d) {
    const double first = static_cast<double>(b) - a;
    const double second = static_cast<double>(d) - c;
    const bool hasFirst = std::isfinite(first);
    const bool hasSecond = std::isfinite(second);
    if (hasFirst && hasSecond)
        return 0.5 * (first + second);
    return hasFirst ? first : (hasSecond ? second : 0.0);
}

}  // namespace

LowerPlane planeBelow(const std::array<float, 4>& depths) {
    const auto slopeX =
        static_cast<float>(meanDifference(depths[0], depths[1], depths[2], depths[3]));
    const auto slopeY =
        static_cast<float>(meanDifference(depths[0], depths[2], depths[1], depths[3]));
    const double alongX = slopeX;
    const double alongY = slopeY;
    const double base = std::min({static_cast<double>(depths[0]), depths[1] - alongX,
                                  depths[2] - alongY, depths[3] - alongX - alongY});
    return {floatBelow(base), slopeX, slopeY};
}

LowerPlane planeBelow(std::span<const PlanePart> parts) {
    double sumX = 0.0;
    double sumY = 0.0;
    for (const PlanePart& part : parts) {
        sumX += part.plane.slopeX;
        sumY += part.plane.slopeY;
    }
    const auto count = static_cast<double>(parts.size());
    LowerPlane whole{0.0f, static_cast<float>(sumX / count), static_cast<float>(sumY / count)};
    const double alongX = whole.slopeX;
    const double alongY = whole.slopeY;
    double base = kInfinity;
    for (const PlanePart& part : parts) {
        const double steeperX = part.plane.slopeX - alongX;
        const double steeperY = part.plane.slopeY - alongY;
        const double atFirst = part.plane.base - alongX * part.column - alongY * part.row;
        base = std::min(base, atFirst + std::min(0.0, steeperX * part.right) +
                                  std::min(0.0, steeperY * part.bottom));
    }
    whole.base = floatBelow(base);
    return whole;
}

}  // namespace relievo::preprocess
