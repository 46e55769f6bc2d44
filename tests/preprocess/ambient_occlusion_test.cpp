#include "preprocess/ambient_occlusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "preprocess/horizon_map.h"
#include "textures/depth_map.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr int kSize = 64;
constexpr double kScale = 0.2;

// A trench along v from column `left` to `right`, as deep as the relief.
DepthMap trench(int left, int right) {
    DepthMap map{Plane(kSize, kSize, 0.0f), WrapMode::Clamp};
    for (int j = 0; j < kSize; ++j)
        for (int i = left; i <= right; ++i)
            map.depth.at(i, j) = 1.0f;
    return map;
}

Plane occlusionOf(const DepthMap& map, int azimuths, double scale) {
    std::vector<Plane> horizons;
    for (int k = 0; k < azimuths; ++k)
        horizons.push_back(buildHorizon(map, azimuthOf(k, azimuths)));
    std::vector<const Plane*> views;
    for (const Plane& horizon : horizons)
        views.push_back(&horizon);
    return buildOcclusion(views, scale);
}

TEST(AmbientOcclusion, IsOneOnAPlainAndAtDepthScaleZero) {
    const DepthMap plain{Plane(7, 5, 0.4f), WrapMode::Repeat};
    EXPECT_EQ(occlusionOf(plain, 8, kScale).texels, Plane(7, 5, 1.0f).texels);
    EXPECT_EQ(occlusionOf(trench(20, 30), 8, 0.0).texels, Plane(kSize, kSize, 1.0f).texels);
}

// Seen from the middle of a trench as deep as d that is w wide, the walls are at tangents
// 2d/w·|cos φ|: the mean of 1/(1 + q²·cos²φ) over φ is 1/√(1 + q²).
TEST(AmbientOcclusion, OfAnInfiniteTrenchIsTheClosedForm) {
    const DepthMap map = trench(28, 36);
    const double tangent = kScale * kSize / 5.0;  // the edges lie 5 texels from its middle
    EXPECT_NEAR(occlusionOf(map, 32, kScale).at(32, 32), 1.0 / std::sqrt(1.0 + tangent * tangent),
                2e-3);
}

// Half of the sky is as over a trench, the other is open.
TEST(AmbientOcclusion, BelowAnInfiniteStepIsTheClosedForm) {
    const DepthMap map = trench(0, 36);
    const double tangent = kScale * kSize / 5.0;
    const double expected = 0.5 + 0.5 / std::sqrt(1.0 + tangent * tangent);
    const double occlusion = occlusionOf(map, 32, kScale).at(32, 32);
    EXPECT_NEAR(occlusion, expected, 2e-3);
    EXPECT_GT(std::abs(occlusionOf(map, 32, 2 * kScale).at(32, 32) - expected), 2e-2)
        << "another depth scale is told apart";
    EXPECT_EQ(occlusionOf(map, 32, kScale).at(40, 32), 1.0f) << "above it";
}

}  // namespace
}  // namespace relievo::preprocess
