#include "preprocess/crest_tree.h"

#include <limits>

namespace relievo::preprocess {
namespace {

using textures::Plane;

constexpr float kNowhere = std::numeric_limits<float>::infinity();

constexpr Sectors sectorBit(int quadrant, int steep) {
    return static_cast<Sectors>(1 << (2 * quadrant + steep));
}

// The sectors of one quadrant where the depth grows: along one of the two directions that bound the
// sector, of which all others are sums.
Sectors deepeningOf(int quadrant, float alongX, float alongY) {
    const bool both = alongX + alongY > 0.0f;
    Sectors sectors = 0;
    if (alongX > 0.0f || both)
        sectors |= sectorBit(quadrant, 0);
    if (alongY > 0.0f || both)
        sectors |= sectorBit(quadrant, 1);
    return sectors;
}

GradientBox unionOf(const GradientBox& a, const GradientBox& b) {
    return {std::min(a.xLeast, b.xLeast), std::max(a.xMost, b.xMost), std::min(a.yLeast, b.yLeast),
            std::max(a.yMost, b.yMost)};
}

CrestTree::Node emptyNode() {
    CrestTree::Node node;
    node.least.fill(kNowhere);
    node.gradients = {kNowhere, -kNowhere, kNowhere, -kNowhere};
    return node;
}

void add(CrestTree::Node& node, const CrestLeaf& leaf) {
    for (std::size_t k = 0; k < kSectors; ++k)
        if ((leaf.sectors >> k & 1) != 0)
            node.least[k] = std::min(node.least[k], leaf.least);
    node.gradients = unionOf(node.gradients, leaf.gradients);
}

CrestTree::Node nodeOf(const CrestTree& tree, int level, int i, int j) {
    CrestTree::Node node = emptyNode();
    const int right = std::min(2 * i + 2, tree.columnsAt(level - 1));
    const int bottom = std::min(2 * j + 2, tree.rowsAt(level - 1));
    for (int y = 2 * j; y < bottom; ++y)
        for (int x = 2 * i; x < right; ++x) {
            const CrestTree::Node& child = tree.node(level - 1, x, y);
            for (std::size_t k = 0; k < kSectors; ++k)
                node.least[k] = std::min(node.least[k], child.least[k]);
            node.gradients = unionOf(node.gradients, child.gradients);
        }
    return node;
}

// Along each quadrant the gradient at the texel is that of the cell there; where it vanishes the
// twist of the cell decides.
Sectors sectorsAtTexel(const Plane& depths, int i, int j) {
    const float here = depths.at(i, j);
    Sectors sectors = 0;
    for (int quadrant = 0; quadrant < 4; ++quadrant) {
        const int x = quadrant % 2 == 0 ? i + 1 : i - 1;
        const int y = quadrant / 2 == 0 ? j + 1 : j - 1;
        const float alongX = depths.at(x, j) - here;
        const float alongY = depths.at(i, y) - here;
        sectors |= deepeningOf(quadrant, alongX, alongY);
        if (alongX == 0.0f && alongY == 0.0f && depths.at(x, y) > here)
            sectors |= static_cast<Sectors>(sectorBit(quadrant, 0) | sectorBit(quadrant, 1));
    }
    return sectors;
}

}  // namespace

Sectors sectorsThatDeepen(const GradientBox& gradients) noexcept {
    Sectors sectors = 0;
    for (int quadrant = 0; quadrant < 4; ++quadrant)
        sectors |= deepeningOf(quadrant, quadrant % 2 == 0 ? gradients.xMost : -gradients.xLeast,
                               quadrant / 2 == 0 ? gradients.yMost : -gradients.yLeast);
    return sectors;
}

CrestTree buildCrestTree(int columns, int rows, const std::function<CrestLeaf(int, int)>& leaf) {
    CrestTree tree;
    tree.columns = columns;
    tree.rows = rows;
    tree.leastDepth = kNowhere;
    tree.levels.resize(2);
    tree.levels[1].assign(
        static_cast<std::size_t>(tree.columnsAt(1)) * static_cast<std::size_t>(tree.rowsAt(1)),
        emptyNode());
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const CrestLeaf here = leaf(i, j);
            tree.leastDepth = std::min(tree.leastDepth, here.least);
            add(tree.levels[1][static_cast<std::size_t>(j / 2) *
                                   static_cast<std::size_t>(tree.columnsAt(1)) +
                               static_cast<std::size_t>(i / 2)],
                here);
        }
    for (int level = 2; tree.levels.back().size() > 1; ++level) {
        std::vector<CrestTree::Node> nodes;
        nodes.reserve(static_cast<std::size_t>(tree.columnsAt(level)) *
                      static_cast<std::size_t>(tree.rowsAt(level)));
        for (int j = 0; j < tree.rowsAt(level); ++j)
            for (int i = 0; i < tree.columnsAt(level); ++i)
                nodes.push_back(nodeOf(tree, level, i, j));
        tree.levels.push_back(std::move(nodes));
    }
    return tree;
}

Plane withBorder(const textures::DepthMap& map) {
    Plane depths(map.width() + 2, map.height() + 2);
    for (int j = 0; j < depths.height; ++j)
        for (int i = 0; i < depths.width; ++i)
            depths.at(i, j) = map.at(i - 1, j - 1);
    return depths;
}

CrestTree buildCellCrestTree(const Plane& depths) {
    return buildCrestTree(depths.width - 1, depths.height - 1, [&](int i, int j) {
        const float d0 = depths.at(i, j);
        const float d1 = depths.at(i + 1, j);
        const float d2 = depths.at(i, j + 1);
        const float d3 = depths.at(i + 1, j + 1);
        const GradientBox gradients = gradientsOf(d0, d1, d2, d3);
        return CrestLeaf{std::min({d0, d1, d2, d3}), sectorsThatDeepen(gradients), gradients};
    });
}

CrestTree buildTexelCrestTree(const Plane& depths) {
    return buildCrestTree(depths.width - 2, depths.height - 2, [&](int i, int j) {
        return CrestLeaf{depths.at(i + 1, j + 1), sectorsAtTexel(depths, i + 1, j + 1),
                         gradientsAtTexel(depths, i + 1, j + 1)};
    });
}

}  // namespace relievo::preprocess
