#include "materials/slope_moments.h"

#include <array>
#include <utility>

#include "textures/halved_plane.h"

namespace relievo::materials {
namespace {

struct Slope {
    double x = 0.0;
    double y = 0.0;
};

// Central differences of the depths, per tile width in the metric.
Slope slopeAt(const textures::DepthMap& relief, int i, int j) {
    const double scale = 0.5 * relief.width();
    return {scale * (static_cast<double>(relief.at(i + 1, j)) - relief.at(i - 1, j)),
            scale * (static_cast<double>(relief.at(i, j + 1)) - relief.at(i, j - 1)) /
                relief.texelAspect};
}

// The slopes of a texel and its neighbours, row by row.
using Neighbourhood = std::array<Slope, 9>;

// Along an axis, the mean over a texel of the product of two functions that are linear between the
// centres of texels: the shares of each of the three values of the one times each of the other,
// ∫ hₖ(t)·hₗ(t) dt of the hat functions over [−½, ½].
constexpr std::array<std::array<double, 3>, 3> kShares = {{
    {1.0 / 24.0, 2.0 / 24.0, 0.0},
    {2.0 / 24.0, 14.0 / 24.0, 2.0 / 24.0},
    {0.0, 2.0 / 24.0, 1.0 / 24.0},
}};

double meanProduct(const Neighbourhood& slopes, double Slope::*a, double Slope::*b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 9; ++k)
        for (std::size_t l = 0; l < 9; ++l)
            sum += kShares[k / 3][l / 3] * kShares[k % 3][l % 3] * (slopes[k].*a) * (slopes[l].*b);
    return sum;
}

Neighbourhood slopesAround(const textures::DepthMap& relief, int i, int j) {
    Neighbourhood slopes;
    for (int n = 0; n < 9; ++n)
        slopes[static_cast<std::size_t>(n)] = slopeAt(relief, i + n % 3 - 1, j + n / 3 - 1);
    return slopes;
}

SlopeMoments momentsOfTexels(const textures::DepthMap& relief) {
    const textures::Plane empty(relief.width(), relief.height());
    SlopeMoments moments{empty, empty, empty};
    for (int j = 0; j < relief.height(); ++j)
        for (int i = 0; i < relief.width(); ++i) {
            const Neighbourhood slopes = slopesAround(relief, i, j);
            const auto mean = [&](double Slope::*a, double Slope::*b) {
                return static_cast<float>(meanProduct(slopes, a, b));
            };
            moments.xx.at(i, j) = mean(&Slope::x, &Slope::x);
            moments.xy.at(i, j) = mean(&Slope::x, &Slope::y);
            moments.yy.at(i, j) = mean(&Slope::y, &Slope::y);
        }
    return moments;
}

}  // namespace

std::vector<SlopeMoments> slopeMoments(const textures::DepthMap& relief) {
    std::vector<SlopeMoments> levels;
    SlopeMoments moments = momentsOfTexels(relief);
    while (moments.xx.texels.size() > 1) {
        moments = {textures::halvedByArea(moments.xx), textures::halvedByArea(moments.xy),
                   textures::halvedByArea(moments.yy)};
        levels.push_back(moments);
    }
    return levels;
}

}  // namespace relievo::materials
