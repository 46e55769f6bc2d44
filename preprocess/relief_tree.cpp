#include "preprocess/relief_tree.h"

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

// The planes of all nodes of one level, from the level below.
std::vector<LowerPlane> planesOfLevel(const ReliefTree& tree, int level, int columns, int rows) {
    std::vector<LowerPlane> planes;
    planes.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const std::size_t node = tree.index(level, i, j);
            planes.push_back(
                level == 1 ? planeOfTexels(tree.texels[node])
                           : planeOfChildren(tree.quads[static_cast<std::size_t>(level)][node],
                                             level, i, j, tree.width, tree.height));
        }
    return planes;
}

// The quads of the nodes of one level ≥ 2: least depths and planes of their children.
std::vector<ReliefQuad> quadsOfLevel(const Plane& childDepths,
                                     const std::vector<LowerPlane>& childPlanes) {
    const int columns = (childDepths.width + 1) / 2;
    const int rows = (childDepths.height + 1) / 2;
    std::vector<ReliefQuad> quads;
    quads.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            ReliefQuad quad{};
            quad.least = childrenOf(childDepths, i, j);
            for (std::size_t k = 0; k < 4; ++k) {
                if (quad.least[k] == kOutside)
                    continue;
                const LowerPlane& plane = childPlanes[childDepths.index(
                    2 * i + static_cast<int>(k % 2), 2 * j + static_cast<int>(k / 2))];
                quad.base[k] = static_cast<float>(plane.base);
                quad.slopeX[k] = static_cast<float>(plane.slopeX);
                quad.slopeY[k] = static_cast<float>(plane.slopeY);
            }
            quads.push_back(quad);
        }
    return quads;
}

}  // namespace

ReliefTree buildReliefTree(const DepthPyramid& pyramid) {
    const Plane& depth = pyramid.levels.front();
    ReliefTree tree;
    tree.width = depth.width;
    tree.height = depth.height;
    for (int j = 0; j < (depth.height + 1) / 2; ++j)
        for (int i = 0; i < (depth.width + 1) / 2; ++i)
            tree.texels.push_back(childrenOf(depth, i, j));
    tree.leastDepth = pyramid.levels.back().texels.front();
    tree.quads.resize(2);
    for (std::size_t level = 2; level < pyramid.levels.size(); ++level) {
        const Plane& children = pyramid.levels[level - 1];
        tree.quads.push_back(quadsOfLevel(
            children,
            planesOfLevel(tree, static_cast<int>(level) - 1, children.width, children.height)));
    }
    return tree;
}

}  // namespace relievo::preprocess
