#include "preprocess/relaxed_cones_policarpo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "preprocess/cones_by_squares.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A bar from column `first` to column `last` of a row at the bottom.
DepthMap bar(int first, int last, float depth, WrapMode wrap) {
    DepthMap map{Plane(40, 1, 1.0f), wrap};
    for (int i = first; i <= last; ++i)
        map.depth.at(i, 0) = depth;
    return map;
}

// The ray through any texel of the bar's flat top leaves it beyond its far edge: that is what
// limits the cone, not the near one.
TEST(RelaxedConesByRays, ReachTheFarEdgeOfAFlatTop) {
    const Plane ratio = buildRelaxedConesByRays(bar(20, 25, 0.0f, WrapMode::Clamp));
    for (int i = 0; i < 19; ++i) {
        EXPECT_GE(ratio.at(i, 0) * 40, 25 - i) << i;
        EXPECT_LE(ratio.at(i, 0) * 40, 25 - i + 1) << i;
    }
    for (int i = 27; i < 40; ++i) {
        EXPECT_GE(ratio.at(i, 0) * 40, i - 20) << i;
        EXPECT_LE(ratio.at(i, 0) * 40, i - 20 + 1) << i;
    }
    for (int i = 20; i <= 25; ++i)
        EXPECT_EQ(ratio.at(i, 0), kInfinity) << i;
}

// Repeat: the copy of the bar on the other side is nearer for texel 2.
TEST(RelaxedConesByRays, SeeTheNearestCopy) {
    const Plane clamped = buildRelaxedConesByRays(bar(30, 36, 0.0f, WrapMode::Clamp));
    const Plane repeated = buildRelaxedConesByRays(bar(30, 36, 0.0f, WrapMode::Repeat));
    EXPECT_GE(clamped.at(2, 0) * 40, 36 - 2);
    EXPECT_GE(repeated.at(2, 0) * 40, 40 + 2 - 30);
    EXPECT_LE(repeated.at(2, 0) * 40, 40 + 2 - 30 + 1);
}

// In tile widths, whatever the resolution and the shape of texels.
TEST(RelaxedConesByRays, FollowTheShapeOfTexels) {
    DepthMap map{Plane(1, 40, 1.0f), WrapMode::Clamp, 0.5};
    map.depth.at(0, 30) = 0.0f;
    const Plane ratio = buildRelaxedConesByRays(map);
    EXPECT_GE(ratio.at(0, 10), 0.5f * 20);
    EXPECT_LE(ratio.at(0, 10), 0.5f * 21);
}

TEST(RelaxedConesByRays, AreWiderThanConservativeOnesOnTheWhole) {
    for (const char* const name : {"noise", "blocks"}) {
        const DepthMap map = textures::generateSampleRelief(name, 24, 20);
        const Plane conservative = buildConesBySquares(map);
        const Plane relaxed = buildRelaxedConesByRays(map);
        double sumConservative = 0.0;
        double sumRelaxed = 0.0;
        for (std::size_t k = 0; k < relaxed.texels.size(); ++k) {
            sumConservative += std::min(conservative.texels[k], 1.0f);
            sumRelaxed += std::min(relaxed.texels[k], 1.0f);
        }
        EXPECT_GT(sumRelaxed, 1.2 * sumConservative) << name;
    }
}

// Why they are a baseline only. A wall at column 10, and behind it a slope that sinks more slowly
// than every ray from above texel 0: such a ray never comes out of it again. A level ray at depth ½
// does, at column 13⅓, so no cone on texel 0 may be wider than that.
TEST(RelaxedConesByRays, MissASlopeThatGrazingRaysComeOutOf) {
    DepthMap map{Plane(31, 1, 1.0f), WrapMode::Clamp};
    for (int i = 10; i < 31; ++i)
        map.depth.at(i, 0) = 0.4f + 0.03f * static_cast<float>(i - 10);
    const float widest = 13.4f / 31 / (1.0f - 0.5f);
    EXPECT_GT(buildRelaxedConesByRays(map).at(0, 0), widest);
    EXPECT_LT(buildConesBySquares(map).at(0, 0), widest);
}

}  // namespace
}  // namespace relievo::preprocess
