#include "preprocess/relief_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/preprocess/small_reliefs.h"
#include "textures/depth_pyramid.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;

constexpr std::pair<int, int> kSizes[] = {{1, 1}, {2, 2},  {1, 9},   {16, 1},
                                          {5, 3}, {31, 7}, {64, 64}, {127, 33}};

Plane noise(int width, int height) {
    return noiseMap(width, height, textures::WrapMode::Repeat, 1).depth;
}

TEST(DepthPyramid, HoldsTheLeastDepthOfEverySquare) {
    for (const auto& [width, height] : kSizes) {
        const Plane depth = noise(width, height);
        const textures::DepthPyramid pyramid = textures::buildDepthPyramid(depth);
        for (std::size_t k = 0; k < pyramid.levels.size(); ++k) {
            const Plane& level = pyramid.levels[k];
            Plane least(level.width, level.height, 2.0f);
            for (int j = 0; j < height; ++j)
                for (int i = 0; i < width; ++i) {
                    float& value = least.at(i >> k, j >> k);
                    value = std::min(value, depth.at(i, j));
                }
            EXPECT_EQ(level.texels, least.texels) << width << "x" << height << " level " << k;
        }
        EXPECT_EQ(pyramid.levels.back().texels.size(), 1u);
    }
}

// How many texels are under the bounds of child k of node (i,j) of `level`; its best slack is
// lowered to `slack`.
std::size_t countBelow(const ReliefTree& tree, const Plane& depth, int level, int i, int j, int k,
                       double& slack) {
    const auto child = static_cast<std::size_t>(k);
    const ReliefQuad& quad = tree.quads[static_cast<std::size_t>(level)][tree.index(level, i, j)];
    const int size = 1 << (level - 1);
    const int left = size * (2 * i + k % 2);
    const int top = size * (2 * j + k / 2);
    std::size_t below = 0;
    for (int y = top; y < std::min(top + size, depth.height); ++y)
        for (int x = left; x < std::min(left + size, depth.width); ++x) {
            const double value = depth.at(x, y);
            const double plane = quad.base[child] +
                                 static_cast<double>(quad.slopeX[child]) * (x - left) +
                                 static_cast<double>(quad.slopeY[child]) * (y - top);
            below += value < plane || value < quad.least[child] ? 1 : 0;
            slack = std::min(slack, value - plane);
        }
    return below;
}

std::size_t countBelow(const ReliefTree& tree, const Plane& depth, double* largestSlack = nullptr) {
    std::size_t below = 0;
    for (int level = 2; level <= tree.topLevel(); ++level)
        for (int j = 0; j << level < depth.height; ++j)
            for (int i = 0; i << level < depth.width; ++i)
                for (int k = 0; k < 4; ++k) {
                    double slack = 1e9;
                    below += countBelow(tree, depth, level, i, j, k, slack);
                    if (largestSlack != nullptr && slack < 1e9)
                        *largestSlack = std::max(*largestSlack, slack);
                }
    return below;
}

TEST(ReliefTree, BoundsEveryTexelFromBelow) {
    for (const auto& [width, height] : kSizes) {
        const Plane depth = noise(width, height);
        const ReliefTree tree = buildReliefTree(depth);
        EXPECT_EQ(countBelow(tree, depth), 0u) << width << "x" << height;
    }
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        const Plane depth = textures::generateSampleRelief(sample.name, 61, 47).depth;
        EXPECT_EQ(countBelow(buildReliefTree(depth), depth), 0u) << sample.name;
    }
}

TEST(ReliefTree, IsTightOnARamp) {
    Plane ramp(64, 32);
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 64; ++i)
            ramp.at(i, j) = static_cast<float>(i + 2 * j) / 128.0f;
    double slack = 0.0;
    EXPECT_EQ(countBelow(buildReliefTree(ramp), ramp, &slack), 0u);
    EXPECT_EQ(slack, 0.0);
}

TEST(ReliefTree, IsCaughtWhenAPlaneIsTooHigh) {
    const Plane depth = noise(31, 7);
    ReliefTree tree = buildReliefTree(depth);
    tree.quads[2][0].base[0] += 0.01f;
    tree.quads[3][0].slopeX[0] += 0.1f;
    EXPECT_GT(countBelow(tree, depth), 0u);
}

}  // namespace
}  // namespace relievo::preprocess
