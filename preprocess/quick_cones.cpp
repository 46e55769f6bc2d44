#include "preprocess/quick_cones.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "preprocess/round_down.h"
#include "textures/depth_pyramid.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;

// The nodes of one axis at one level.
struct Axis {
    int texels;
    int level;
    bool repeats;

    [[nodiscard]] int nodes() const { return (texels + (1 << level) - 1) >> level; }
    // The node with this index, which is at most one step outside; -1 where there is none.
    [[nodiscard]] int node(int index) const {
        if (index >= 0 && index < nodes())
            return index;
        return repeats ? (index + nodes()) % nodes() : -1;
    }
    // Whether `node` is the one of texel `apex` or next to it.
    [[nodiscard]] bool isNear(int apex, int node) const {
        const int difference = std::abs(node - (apex >> level));
        return difference <= 1 || (repeats && difference == nodes() - 1);
    }
    // Steps of index from texel `apex` to the nearest texel of `node`, in its nearest copy.
    [[nodiscard]] int distance(int apex, int node) const {
        const int first = (node << level) - apex;
        const int last = std::min((node + 1) << level, texels) - 1 - apex;
        const int direct = std::max({0, first, -last});
        if (!repeats)
            return direct;
        return std::min({direct, std::max(0, first + texels), std::max(0, texels - last)});
    }
};

// The walk up the pyramid from one apex.
class PyramidWalk {
  public:
    PyramidWalk(const textures::DepthMap& map, const textures::DepthPyramid& pyramid, int i, int j)
        : map_(map), pyramid_(pyramid), i_(i), j_(j), depth_(map.depth.at(i, j)) {}

    // The least bound on squared ratios, in texels per unit of depth.
    double walk() {
        tryNodesNear(0);
        for (int level = 1; level < static_cast<int>(pyramid_.levels.size()); ++level)
            tryChildrenNear(level);
        return leastSquared_;
    }

  private:
    [[nodiscard]] Axis columns(int level) const {
        return {map_.width(), level, map_.wrap == textures::WrapMode::Repeat};
    }
    [[nodiscard]] Axis rows(int level) const {
        return {map_.height(), level, map_.wrap == textures::WrapMode::Repeat};
    }

    void tryNode(int level, int x, int y) {
        const double difference =
            depth_ - pyramid_.levels[static_cast<std::size_t>(level)].at(x, y);
        if (difference <= 0.0)
            return;
        const double across = columns(level).distance(i_, x);
        const double down = rows(level).distance(j_, y) * map_.texelAspect;
        leastSquared_ =
            std::min(leastSquared_, (across * across + down * down) / (difference * difference));
    }

    void tryNodesNear(int level) {
        for (int row = -1; row <= 1; ++row)
            for (int column = -1; column <= 1; ++column) {
                const int x = columns(level).node((i_ >> level) + column);
                const int y = rows(level).node((j_ >> level) + row);
                if (x >= 0 && y >= 0)
                    tryNode(level, x, y);
            }
    }

    // The children of the nodes around the apex that were not near it in their own level: those
    // were done there, or their children were.
    void tryChildrenNear(int level) {
        for (int row = -1; row <= 1; ++row)
            for (int column = -1; column <= 1; ++column) {
                const int x = columns(level).node((i_ >> level) + column);
                const int y = rows(level).node((j_ >> level) + row);
                if (x >= 0 && y >= 0)
                    tryChildren(level, x, y);
            }
    }

    void tryChildren(int level, int x, int y) {
        const Axis across = columns(level - 1);
        const Axis down = rows(level - 1);
        for (int childY = 2 * y; childY < std::min(2 * y + 2, down.nodes()); ++childY)
            for (int childX = 2 * x; childX < std::min(2 * x + 2, across.nodes()); ++childX)
                if (!across.isNear(i_, childX) || !down.isNear(j_, childY))
                    tryNode(level - 1, childX, childY);
    }

    const textures::DepthMap& map_;
    const textures::DepthPyramid& pyramid_;
    int i_;
    int j_;
    double depth_;
    double leastSquared_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Plane buildQuickCones(const textures::DepthMap& map,
                      const std::function<void(std::size_t)>& advance) {
    const textures::DepthPyramid pyramid = textures::buildDepthPyramid(map.depth);
    Plane ratio(map.width(), map.height());
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int i = 0; i < map.width(); ++i) {
            const double texels = std::sqrt(PyramidWalk(map, pyramid, i, j).walk());
            ratio.at(i, j) = roundDown(belowRounding(texels / map.width()));
        }
        if (advance)
            advance(static_cast<std::size_t>(map.width()));
    });
    return ratio;
}

}  // namespace relievo::preprocess
