// Roof cones by their definition keep their promise in every wrap mode; what is wrong is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/guarantee_check.h"
#include "reference/ray_sector.h"
#include "safe_maps.h"

namespace relievo::reference::test {
namespace {

using textures::DepthMap;
using textures::WrapMode;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

std::uint64_t violationsOf(const DepthMap& relief, const RoofMap& roofs,
                           std::uint64_t rays = 20000) {
    GuaranteeCheckOptions options;
    options.rays = rays;
    return checkRoofs(relief, roofs, options).violations;
}

void expectSafe(const DepthMap& relief, int layers, int block) {
    EXPECT_EQ(violationsOf(relief, bruteForceRoofs(relief, layers, block)), 0u)
        << relief.width() << "x" << relief.height() << " " << wrapModeName(relief.wrap) << " "
        << layers << " layers, block " << block;
}

TEST(RoofCheck, BruteForceIsSafeForEveryWrapModeLayersAndBlock) {
    for (const WrapMode wrap : kWraps)
        for (const int layers : {1, 4, 8})
            for (const int block : {1, 2, 3})
                expectSafe(noiseRelief(9, 5, wrap, 2), layers, block);
}

TEST(RoofCheck, BruteForceIsSafeForEveryShape) {
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair(1, 1), {1, 6}, {5, 1}, {2, 2}, {2, 3}})
            for (const int layers : {1, 4, 8})
                expectSafe(noiseRelief(width, height, wrap, 3, width == 2), layers, 1);
    DepthMap flat = noiseRelief(9, 8, WrapMode::Mirror, 4);
    flat.texelAspect = 0.6;
    for (const int layers : {1, 4, 8})
        expectSafe(flat, layers, 2);
}

// Blocks of 0 and 1 in a level plain of 1: roofs of the plain see far.
DepthMap fewBlocks() {
    DepthMap relief{textures::Plane(12, 10, 1.0f), WrapMode::Repeat};
    for (int j = 3; j < 6; ++j)
        for (int i = 8; i < 10; ++i)
            relief.depth.at(i, j) = 0.2f;
    return relief;
}

TEST(RoofCheck, WhatIsWrongIsFound) {
    const DepthMap relief = fewBlocks();
    for (const int layers : {1, 4, 8}) {
        const RoofMap right = bruteForceRoofs(relief, layers, 1);
        EXPECT_EQ(violationsOf(relief, right), 0u);
        RoofMap wide = right;
        RoofMap deep = right;
        RoofMap largerBlock = right;
        largerBlock.block = 2;
        for (int k = 0; k < layers; ++k) {
            for (float& ratio : wide.layers[static_cast<std::size_t>(k)].ratio.texels)
                ratio *= 1.5f;
            for (float& roof : deep.layers[static_cast<std::size_t>(k)].roof.texels)
                roof = std::min(1.2f * roof, 1.0f);
        }
        EXPECT_GT(violationsOf(relief, wide), 5u) << layers;
        EXPECT_GT(violationsOf(relief, deep), 5u) << layers;
        EXPECT_GT(violationsOf(relief, largerBlock), 5u) << layers;
    }
}

TEST(RoofCheck, LayersInAnotherOrderAreFound) {
    const DepthMap relief = fewBlocks();
    for (const int layers : {4, 8}) {
        RoofMap swapped = bruteForceRoofs(relief, layers, 1);
        std::reverse(swapped.layers.begin(), swapped.layers.end());
        EXPECT_GT(violationsOf(relief, swapped), 100u);
    }
}

// Mirrored tiles must read the mirrored sector.
TEST(RoofCheck, MapOfAnotherWrapModeIsFound) {
    const DepthMap relief = noiseRelief(8, 8, WrapMode::Repeat, 12);
    DepthMap mirrored = relief;
    mirrored.wrap = WrapMode::Mirror;
    EXPECT_GT(violationsOf(mirrored, bruteForceRoofs(relief, 4, 1)), 0u);
}

TEST(RoofMap, SectorsOfDirections) {
    EXPECT_EQ(raySector({-1.0, -1.0}, 1.0, 1), 0);
    EXPECT_EQ(raySector({1.0, 0.5}, 1.0, 4), 0);
    EXPECT_EQ(raySector({-1.0, 0.5}, 1.0, 4), 1);
    EXPECT_EQ(raySector({1.0, -0.5}, 1.0, 4), 2);
    EXPECT_EQ(raySector({-1.0, -0.5}, 1.0, 4), 3);
    EXPECT_EQ(raySector({1.0, 0.5}, 1.0, 8), 0);
    EXPECT_EQ(raySector({1.0, 1.0}, 1.0, 8), 0);
    EXPECT_EQ(raySector({1.0, 0.5}, 3.0, 8), 4);
    EXPECT_EQ(raySector({-0.2, -0.5}, 1.0, 8), 7);
}

TEST(RoofMap, BlocksEndAtCellBorders) {
    EXPECT_DOUBLE_EQ(blockExit({2.25, 3.5}, {0.5, 0.1}, 2, 3, 1), 3.5);
    EXPECT_DOUBLE_EQ(blockExit({2.25, 3.5}, {-0.5, 0.1}, 2, 3, 1), 2.5);
    EXPECT_DOUBLE_EQ(blockExit({2.25, 3.5}, {0.0, -1.0}, 2, 3, 2), 2.5);
    EXPECT_TRUE(std::isinf(blockExit({2.25, 3.5}, {0.0, 0.0}, 2, 3, 1)));
}

}  // namespace
}  // namespace relievo::reference::test
