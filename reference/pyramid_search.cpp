#include "reference/pyramid_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace relievo::reference {

namespace {

// The node of a level that holds a cell, along one axis: its place in the level and where its cells
// begin and end, not wrapped. Nodes do not cross the border of the tile.
struct NodeSpan {
    int node;
    std::int64_t first;
    std::int64_t end;
};

NodeSpan nodeOf(std::int64_t cell, int level, int size) {
    const int inTile = textures::wrapIndex(cell, size, textures::WrapMode::Repeat);
    const std::int64_t tile = cell - inTile;
    const int node = inTile >> level;
    return {node, tile + (std::int64_t{node} << level),
            tile + std::min(std::int64_t{node + 1} << level, std::int64_t{size})};
}

// The depth at which a ray in texel coordinates leaves the cells [first, end) of an axis. A single
// texel is constant without end, like its cell in CellWalk.
double exitOf(const NodeSpan& span, int size, double start, double slope) {
    if (slope == 0.0 || size == 1)
        return std::numeric_limits<double>::infinity();
    return (static_cast<double>(slope > 0.0 ? span.end : span.first) - start) / slope;
}

class PyramidWalk {
  public:
    PyramidWalk(const textures::DepthMap& relief, std::span<const textures::Plane> levels,
                const DescendingRay& ray)
        : levels_(levels),
          size_(relief.width(), relief.height()),
          start_(ray.start * glm::dvec2(size_) - 0.5),
          slope_(ray.slope * glm::dvec2(size_)),
          walk_(walkOver(relief, ray)),
          level_(static_cast<int>(levels.size()) - 1) {}

    MapSearchResult search() {
        MapSearchResult result;
        for (;;) {
            ++result.lookups;
            const NodeSpan across = nodeOf(walk_.columns().cell(), level_, size_.x);
            const NodeSpan down = nodeOf(walk_.rows().cell(), level_, size_.y);
            const double least =
                levels_[static_cast<std::size_t>(level_)].at(across.node, down.node);
            const double exit = std::min(exitOf(across, size_.x, start_.x, slope_.x),
                                         exitOf(down, size_.y, start_.y, slope_.y));
            if (exit < least) {
                leave(exit);
            } else if (level_ > 0) {
                if (walk_.entry() < least)
                    walk_.jump(std::min(least, 1.0));
                --level_;
            } else if (solveCell(result)) {
                return result;
            }
        }
    }

  private:
    // Into the next node; up again, because what is beyond the node may well be as empty.
    void leave(double exit) {
        if (walk_.isBeyond(exit))
            walk_.jump(exit);
        else
            walk_.step();
        level_ = std::min(level_ + 1, static_cast<int>(levels_.size()) - 1);
    }

    bool solveCell(MapSearchResult& result) {
        ++result.lookups;
        const std::optional<double> hit = hitInCell(walk_);
        if (hit)
            result.z = *hit;
        if (hit || walk_.isLast())
            return true;
        leave(walk_.exit());
        return false;
    }

    std::span<const textures::Plane> levels_;
    glm::ivec2 size_;
    glm::dvec2 start_;  // texel coordinates
    glm::dvec2 slope_;
    CellWalk walk_;
    int level_;
};

}  // namespace

MapSearchResult searchByPyramid(const textures::DepthMap& relief,
                                std::span<const textures::Plane> levels, const DescendingRay& ray) {
    if (relief.wrap != textures::WrapMode::Repeat)
        throw std::invalid_argument("the search in a pyramid is for reliefs that repeat");
    assert(!levels.empty() && levels.front().width == relief.width());
    return PyramidWalk(relief, levels, ray).search();
}

}  // namespace relievo::reference
