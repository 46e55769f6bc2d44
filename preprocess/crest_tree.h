#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Directions in eight sectors of 45° in the plane of texels, both ends included: sector
/// 2·quadrant + steep, quadrant (dx<0) + 2·(dy<0), steep where |dy| ≥ |dx|. Sets are bit masks.
using Sectors = std::uint8_t;
inline constexpr int kSectors = 8;

/// Directions from the points of a rectangle to those of another: dx in [dxFirst,dxLast] and dy
/// likewise, in texels.
struct DirectionRange {
    float dxFirst;
    float dxLast;
    float dyFirst;
    float dyLast;
};

/// Gradients of a bilinear cell are a box: depth per texel along both axes.
struct GradientBox {
    float xLeast;
    float xMost;
    float yLeast;
    float yMost;
};

/// The gradients of a cell with these depths, in the order of ReliefQuad.
inline GradientBox gradientsOf(float d0, float d1, float d2, float d3) noexcept {
    return {std::min(d1 - d0, d3 - d2), std::max(d1 - d0, d3 - d2), std::min(d2 - d0, d3 - d1),
            std::max(d2 - d0, d3 - d1)};
}

/// The gradients at texel (i,j) of `depths`, not of its border, in the four cells around it. Where
/// they vanish along a direction a twist may deepen: the growth by gradients is not negative there.
inline GradientBox gradientsAtTexel(const textures::Plane& depths, int i, int j) noexcept {
    const float* const here = depths.texels.data() + depths.index(i, j);
    const int row = depths.width;
    return {std::min(here[1] - *here, *here - here[-1]),
            std::max(here[1] - *here, *here - here[-1]),
            std::min(here[row] - *here, *here - here[-row]),
            std::max(here[row] - *here, *here - here[-row])};
}

/// All sectors with a direction along which the depth may grow, for a gradient of the box.
Sectors sectorsThatDeepen(const GradientBox& gradients) noexcept;

/// The most that the depth may grow over a step of the range, by any gradient of the box.
inline float mostGrowth(const GradientBox& gradients, const DirectionRange& range) noexcept {
    const auto most = [](float least, float greatest, float first, float last) {
        return std::max(std::max(least * first, least * last),
                        std::max(greatest * first, greatest * last));
    };
    return most(gradients.xLeast, gradients.xMost, range.dxFirst, range.dxLast) +
           most(gradients.yLeast, gradients.yMost, range.dyFirst, range.dyLast);
}

/// A texel or a cell as seen from elsewhere: its least depth, and the directions in which a ray may
/// come out of the relief there.
struct CrestLeaf {
    float least;
    Sectors sectors;
    GradientBox gradients;
};

/// A quadtree over texels or cells for searches that must rule out large squares: for each node all
/// gradients, and for each sector the least depth of the leaves where a ray in a direction of the
/// sector may come out of the relief, +infinity without one.
///
/// On a slope nothing comes out until its crest, however near and high it is: there a node is ruled
/// out by its gradients where it is smooth, by its sectors where it is not.
struct CrestTree {
    struct Node {
        std::array<float, kSectors> least;
        GradientBox gradients;
    };

    int columns = 0;
    int rows = 0;
    float leastDepth = 0.0f;  ///< of all leaves, facing away or not
    /// levels[k]: nodes of 2ᵏ × 2ᵏ leaves, row by row, up to the only node of the top; levels[0] is
    /// empty.
    std::vector<std::vector<Node>> levels;

    [[nodiscard]] int topLevel() const noexcept { return static_cast<int>(levels.size()) - 1; }
    [[nodiscard]] int columnsAt(int level) const noexcept {
        return (columns + (1 << level) - 1) >> level;
    }
    [[nodiscard]] int rowsAt(int level) const noexcept {
        return (rows + (1 << level) - 1) >> level;
    }
    [[nodiscard]] const Node& node(int level, int i, int j) const noexcept {
        return levels[static_cast<std::size_t>(level)]
                     [static_cast<std::size_t>(j) * static_cast<std::size_t>(columnsAt(level)) +
                      static_cast<std::size_t>(i)];
    }
};

/// The tree over columns × rows leaves, in linear time and 16 bytes a leaf.
CrestTree buildCrestTree(int columns, int rows, const std::function<CrestLeaf(int, int)>& leaf);

/// The depths of a map with one more texel on all sides, as the wrap mode has them: texel (i,j) of
/// the map is (i+1,j+1).
textures::Plane withBorder(const textures::DepthMap& map);

/// The cells between the samples of `depths` (withBorder), the one whose first corner is (i,j) as
/// leaf (i,j): rays come out anywhere in a cell.
CrestTree buildCellCrestTree(const textures::Plane& depths);

/// The texels inside the border of `depths`: rays come out at their centres only.
CrestTree buildTexelCrestTree(const textures::Plane& depths);

}  // namespace relievo::preprocess
