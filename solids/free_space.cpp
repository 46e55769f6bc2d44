#include "solids/free_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo::solids {
namespace {

using textures::Plane;
using textures::wrapIndex;

// Distances are stored as floats: what rounding to the nearest one may add to or take from them.
constexpr double kFloatRounding = 0x1p-23;
// What computing a clearance in doubles may.
constexpr double kDoubleRounding = 0x1p-48;
constexpr double kSafety = 1.0 - 1e-12;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

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
    : texels_(map.width()),
      slack_(map.slack * map.width()),
      creaseDepth_(textures::creaseDepth(map)) {
    const double steepest = largestStep(map.steps(), wrap) * texels_;
    double farthest = 0.0;
    for (const float d : map.steps().texels)
        farthest = std::max(farthest, std::abs(static_cast<double>(d)) * texels_);
    isDistance_ = isDistance && steepest <= 1.0 + slack_ + 2.0 * kFloatRounding * farthest;
    // Of a constant map the reach has no end, but the square of a number.
    measuredFactor_ = 0.5 / (std::max(steepest, 1e-30) * std::max(steepest, 1e-30));
}

std::array<ReachTerm, 3> FreeSpace::terms(double distance) const noexcept {
    const double size = std::abs(distance) * texels_;
    const double rounded = slack_ + 4.0 * kFloatRounding * size;
    const ReachTerm measured{measuredFactor_, 0.0, kDoubleRounding * size};
    if (!isDistance_)
        return {measured, measured, measured};
    return {measured, ReachTerm{0.5, 0.0, rounded}, ReachTerm{1.0, 0.5, rounded}};
}

double FreeSpace::radius(double distance, double low, double high) const noexcept {
    const double clear = std::max(distance - high, low - (distance + creaseDepth_)) * texels_;
    double square = 0.0;
    for (const ReachTerm& term : terms(distance)) {
        const double sure = std::max(0.0, clear - term.uncertainty);
        square = std::max(square, term.factor * sure * sure - term.less);
    }
    return std::sqrt(square);
}

double FreeSpace::duration(double distance, double clear, double closing,
                           double speed) const noexcept {
    double longest = 0.0;
    for (const ReachTerm& term : terms(distance)) {
        const double sure = clear * texels_ - term.uncertainty;
        const double rate = std::max(0.0, closing) * texels_;
        const double square = term.factor * sure * sure - term.less;
        if (!(sure > 0.0) || !(square > 0.0))
            continue;
        // The first root of factor·(sure − rate·t)² = (speed·t)² + less, without cancellation.
        const double half = term.factor * rate * sure;
        const double root =
            std::sqrt(term.factor * rate * rate * term.less + speed * speed * square);
        const double divisor = half + root;
        longest = std::max(longest, divisor > 0.0 ? square / divisor : kInfinity);
    }
    return kSafety * longest;
}

}  // namespace relievo::solids
