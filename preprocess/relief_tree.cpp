#include "preprocess/relief_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo::preprocess {
namespace {

using textures::Plane;

constexpr float kOutside = std::numeric_limits<float>::infinity();

// A plane below the surface over one node: base at its first texel, slopes per texel.
struct LowerPlane {
    double base = 0.0;
    double slopeX = 0.0;
    double slopeY = 0.0;
};

// The texels of a node along one axis that the map has: offsets 0…last from its first.
int lastOffset(int level, int node, int size) {
    return std::min(1 << level, size - (node << level)) - 1;
}

std::array<float, 4> childrenOf(const Plane& level, int i, int j) {
    std::array<float, 4> values;
    for (int k = 0; k < 4; ++k) {
        const int x = 2 * i + k % 2;
        const int y = 2 * j + k / 2;
        values[static_cast<std::size_t>(k)] =
            x < level.width && y < level.height ? level.at(x, y) : kOutside;
    }
    return values;
}

// The largest float that is not above `value`. The slopes of a plane are rounded first, and its
// base is lowered to what the rounded slopes need, so that the stored plane is below the surface.
float floatBelow(double value) {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) > value ? std::nextafter(nearest, -kOutside) : nearest;
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

// The plane below the 2×2 texels of a node of level 1 with their mean slope.
LowerPlane planeOfTexels(const std::array<float, 4>& depth) {
    LowerPlane plane;
    plane.slopeX = static_cast<float>(meanDifference(depth[0], depth[1], depth[2], depth[3]));
    plane.slopeY = static_cast<float>(meanDifference(depth[0], depth[2], depth[1], depth[3]));
    plane.base = std::min({static_cast<double>(depth[0]), depth[1] - plane.slopeX,
                           depth[2] - plane.slopeY, depth[3] - plane.slopeX - plane.slopeY});
    plane.base = floatBelow(plane.base);
    return plane;
}

// The plane below a node of `level` from the planes of its children: their mean slope, and as high
// as the children's planes allow at the corners of the children.
LowerPlane planeOfChildren(const ReliefQuad& quad, int level, int i, int j, int width, int height) {
    LowerPlane plane;
    double count = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
        if (quad.least[k] != kOutside) {
            plane.slopeX += quad.slopeX[k];
            plane.slopeY += quad.slopeY[k];
            count += 1.0;
        }
    plane.slopeX = static_cast<float>(plane.slopeX / count);
    plane.slopeY = static_cast<float>(plane.slopeY / count);

    const int childSize = 1 << (level - 1);
    plane.base = kOutside;
    for (std::size_t k = 0; k < 4; ++k) {
        if (quad.least[k] == kOutside)
            continue;
        const int column = static_cast<int>(k % 2);
        const int row = static_cast<int>(k / 2);
        const int right = lastOffset(level - 1, 2 * i + column, width);
        const int bottom = lastOffset(level - 1, 2 * j + row, height);
        const double steeperX = quad.slopeX[k] - plane.slopeX;
        const double steeperY = quad.slopeY[k] - plane.slopeY;
        const double atFirst =
            quad.base[k] - plane.slopeX * column * childSize - plane.slopeY * row * childSize;
        plane.base = std::min(plane.base, atFirst + std::min(0.0, steeperX * right) +
                                              std::min(0.0, steeperY * bottom));
    }
    plane.base = floatBelow(plane.base);
    return plane;
}

int columnsOf(int level, int width) {
    return (width + (1 << level) - 1) >> level;
}

// The quad of a node of level ≥ 2: least depths and planes of its children, from the level below.
ReliefQuad quadOf(const ReliefTree& tree, int level, int i, int j) {
    const int childLevel = level - 1;
    ReliefQuad quad{};
    quad.least.fill(kOutside);
    for (std::size_t k = 0; k < 4; ++k) {
        const int x = 2 * i + static_cast<int>(k % 2);
        const int y = 2 * j + static_cast<int>(k / 2);
        if (x >= columnsOf(childLevel, tree.width) || y >= columnsOf(childLevel, tree.height))
            continue;
        const std::size_t child = tree.index(childLevel, x, y);
        const auto& children = tree.quads[static_cast<std::size_t>(childLevel)];
        const LowerPlane plane = childLevel == 1 ? planeOfTexels(tree.texels[child])
                                                 : planeOfChildren(children[child], childLevel, x,
                                                                   y, tree.width, tree.height);
        quad.least[k] =
            std::ranges::min(childLevel == 1 ? tree.texels[child] : children[child].least);
        quad.base[k] = static_cast<float>(plane.base);
        quad.slopeX[k] = static_cast<float>(plane.slopeX);
        quad.slopeY[k] = static_cast<float>(plane.slopeY);
    }
    return quad;
}

}  // namespace

ReliefTree buildReliefTree(const Plane& depth) {
    ReliefTree tree;
    tree.width = depth.width;
    tree.height = depth.height;
    int levels = 2;
    while (columnsOf(levels - 1, depth.width) > 1 || columnsOf(levels - 1, depth.height) > 1)
        ++levels;
    tree.quads.resize(static_cast<std::size_t>(levels));
    for (int level = 1; level < levels; ++level) {
        const std::size_t nodes = static_cast<std::size_t>(columnsOf(level, depth.width)) *
                                  static_cast<std::size_t>(columnsOf(level, depth.height));
        if (level == 1)
            tree.texels.resize(nodes);
        else
            tree.quads[static_cast<std::size_t>(level)].resize(nodes);
    }
    updateReliefTree(tree, depth, {0, 0, depth.width, depth.height});
    return tree;
}

void updateReliefTree(ReliefTree& tree, const Plane& depth, const TexelRectangle& changed) {
    for (int level = 1; level <= tree.topLevel(); ++level) {
        const int bottom = (changed.top + changed.height - 1) >> level;
        const int right = (changed.left + changed.width - 1) >> level;
        tbb::parallel_for((changed.top >> level), bottom + 1, [&](int j) {
            for (int i = changed.left >> level; i <= right; ++i)
                if (level == 1)
                    tree.texels[tree.index(1, i, j)] = childrenOf(depth, i, j);
                else
                    tree.quads[static_cast<std::size_t>(level)][tree.index(level, i, j)] =
                        quadOf(tree, level, i, j);
        });
    }
    tree.leastDepth = std::ranges::min(tree.topLevel() == 1 ? tree.texels.front()
                                                            : tree.quads.back().front().least);
}

}  // namespace relievo::preprocess
