#include "solids/free_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo::solids {
namespace {

using textures::Plane;
using textures::wrapIndex;

// Distances are stored as floats: what rounding to the nearest one may add to or take from them.
constexpr double kFloatRounding = 0x1p-23;

// The largest difference between neighbours, in tile widths.
double largestStep(const Plane& distance, textures::WrapMode wrap) {
    double largest = 0.0;
    for (int j = 0; j < distance.height; ++j)
        for (int i = 0; i < distance.width; ++i) {
            const double here = distance.at(i, j);
            const double right = distance.at(wrapIndex(i + 1, distance.width, wrap), j);
            const double below = distance.at(i, wrapIndex(j + 1, distance.height, wrap));
            largest = std::max({largest, std::abs(right - here), std::abs(below - here)});
        }
    return largest;
}

}  // namespace

FreeSpace::FreeSpace(const textures::ShapeMap& map, textures::WrapMode wrap, bool isDistance)
    : texels_(map.width()), slack_(map.slack) {
    const double step = largestStep(map.distance, wrap);
    double farthest = 0.0;
    for (const float d : map.distance.texels)
        farthest = std::max(farthest, std::abs(static_cast<double>(d)));
    const double allowed = 1.0 / texels_ + slack_ + 2.0 * kFloatRounding * farthest;
    isDistance_ = isDistance && step <= allowed;
    steepest_ = std::max(step * texels_, 0x1p-500);
}

double FreeSpace::uncertainty(double distance) const noexcept {
    return (isDistance_ ? slack_ : 0.0) + 4.0 * kFloatRounding * std::abs(distance);
}

double FreeSpace::change(double texels) const noexcept {
    const double gentle = std::numbers::sqrt2 * texels;
    if (!isDistance_)
        return gentle * steepest_ / texels_;
    return std::min(gentle, std::sqrt(texels * texels + 0.5)) / texels_;
}

double FreeSpace::reach(double lengths) const noexcept {
    if (!(lengths > 0.0))
        return 0.0;
    const double f = lengths * texels_;
    const double gentle = f / std::numbers::sqrt2;
    if (!isDistance_)
        return gentle / steepest_;
    return std::max(gentle, std::sqrt(std::max(0.0, f * f - 0.5)));
}

double FreeSpace::radius(double distance, double low, double high) const noexcept {
    const double clear = std::max(distance - high, low - distance);
    return reach(clear - uncertainty(distance));
}

}  // namespace relievo::solids
