#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "textures/plane.h"

namespace relievo::preprocess {

/// Some texels of a map, at least one.
struct TexelRectangle {
    int left;
    int top;
    int width;
    int height;
};

/// Lower bounds on the depths of four squares of texels, the children of one node: child 0 is at
/// the top left, 1 at the top right, 2 and 3 below them. One cache line.
///
/// For child k with first texel (i0,j0) and every texel (i,j) in it:
/// D(i,j) ≥ least[k] and D(i,j) ≥ base[k] + slopeX[k]·(i−i0) + slopeY[k]·(j−j0).
struct alignas(64) ReliefQuad {
    std::array<float, 4> least;  ///< +infinity for a child outside the map
    std::array<float, 4> base;
    std::array<float, 4> slopeX;
    std::array<float, 4> slopeY;
};

/// A quadtree over the texels of a map for searches that must rule out large squares. A node of
/// level k is a square of 2ᵏ × 2ᵏ texels; the only node of the top level is the whole map.
///
/// The planes are what makes smooth slopes cheap: the least depth of a square lies at its far
/// corner and the least distance at its near one, so that a bound from these two is loose on a
/// slope, and nearly all squares along it must be opened. A plane below the surface is tight there.
struct ReliefTree {
    int width = 0;
    int height = 0;
    float leastDepth = 0.0f;  ///< of all texels
    /// Children of the nodes of level 1: the texels, row by row of nodes; +infinity outside.
    std::vector<std::array<float, 4>> texels;
    /// quads[k]: children of the nodes of level k ≥ 2, row by row; 0 and 1 are empty.
    std::vector<std::vector<ReliefQuad>> quads;

    /// Level of the root: 1 for the smallest maps.
    [[nodiscard]] int topLevel() const noexcept { return static_cast<int>(quads.size()) - 1; }
    /// Index of node (i,j) of `level` ≥ 1 in the row-by-row arrays.
    [[nodiscard]] std::size_t index(int level, int i, int j) const noexcept {
        const int columns = (width + (1 << level) - 1) >> level;
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(i);
    }
};

/// The tree of a map of at least one texel, in linear time and about 9.3 bytes a texel.
ReliefTree buildReliefTree(const textures::Plane& depth);

/// Brings the tree of a map up to date after the depths of a rectangle inside the map changed: it
/// is then the tree that buildReliefTree gives, in time linear in the rectangle.
void updateReliefTree(ReliefTree& tree, const textures::Plane& depth,
                      const TexelRectangle& changed);

}  // namespace relievo::preprocess
