#include "preprocess/mip_levels.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/textures/random_planes.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;

TEST(MipLevels, CoverTheSameTileDownToOneTexel) {
    const std::vector<DepthMap> levels =
        reliefLevels({textures::randomPlane(37, 10, 0.0f, 1.0f, 3), textures::WrapMode::Mirror});
    const std::array<std::array<int, 2>, 6> sizes{
        {{37, 10}, {18, 5}, {9, 2}, {4, 1}, {2, 1}, {1, 1}}};
    ASSERT_EQ(levels.size(), sizes.size());
    for (std::size_t k = 0; k < levels.size(); ++k) {
        EXPECT_EQ(levels[k].width(), sizes[k][0]);
        EXPECT_EQ(levels[k].height(), sizes[k][1]);
        EXPECT_DOUBLE_EQ(levels[k].aspect(), 10.0 / 37.0) << "the tile keeps its shape";
        EXPECT_EQ(levels[k].wrap, textures::WrapMode::Mirror);
        EXPECT_NEAR(levels[k].texelAspect, 10.0 / 37.0 * sizes[k][0] / sizes[k][1], 1e-12);
    }
    EXPECT_EQ(levels[0].texelAspect, 1.0);
}

TEST(MipLevels, AConstantStaysConstant) {
    for (const DepthMap& level : reliefLevels({Plane(11, 7, 0.3f), textures::WrapMode::Clamp}))
        for (const float depth : level.depth.texels)
            EXPECT_EQ(depth, 0.3f);
}

}  // namespace
}  // namespace relievo::preprocess
