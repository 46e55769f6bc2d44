#include "preprocess/cones_by_squares.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

// The differences of index from an apex to the texels of an axis, each in its nearest copy.
struct Reach {
    int low;
    int high;
};

Reach reachOf(int apex, int size, textures::WrapMode wrap) {
    if (wrap == textures::WrapMode::Repeat)
        return {-(size / 2), size / 2};
    return {-apex, size - 1 - apex};
}

// The index of the texel at `apex + difference`, which is at most one period off the tile.
int texelAt(int apex, int difference, int size) {
    const int index = apex + difference;
    return index < 0 ? index + size : (index < size ? index : index - size);
}

// The search from one apex.
class SquareSearch {
  public:
    SquareSearch(const textures::DepthMap& map, int i, int j)
        : map_(map),
          i_(i),
          j_(j),
          depth_(map.depth.at(i, j)),
          across_(reachOf(i, map.width(), map.wrap)),
          down_(reachOf(j, map.height(), map.wrap)) {}

    // The least squared ratio, in texels per unit of depth; infinite where nothing is higher.
    double search() {
        const int farthest =
            std::max(std::max(-across_.low, across_.high), std::max(-down_.low, down_.high));
        const double leastStep = std::min(1.0, map_.texelAspect);
        for (int radius = 1; radius <= farthest; ++radius) {
            const double nearest = radius * leastStep;
            if (nearest * nearest >= leastSquared_ * depth_ * depth_)
                break;
            searchSquare(radius);
        }
        return leastSquared_;
    }

  private:
    void searchSquare(int radius) {
        for (const int down : {-radius, radius})
            if (down >= down_.low && down <= down_.high)
                for (int across = std::max(-radius, across_.low);
                     across <= std::min(radius, across_.high); ++across)
                    tryTexel(across, down);
        for (const int across : {-radius, radius})
            if (across >= across_.low && across <= across_.high)
                for (int down = std::max(1 - radius, down_.low);
                     down <= std::min(radius - 1, down_.high); ++down)
                    tryTexel(across, down);
    }

    void tryTexel(int across, int down) {
        const double difference = depth_ - map_.depth.at(texelAt(i_, across, map_.width()),
                                                         texelAt(j_, down, map_.height()));
        if (difference <= 0.0)
            return;
        const double x = across;
        const double y = down * map_.texelAspect;
        leastSquared_ = std::min(leastSquared_, (x * x + y * y) / (difference * difference));
    }

    const textures::DepthMap& map_;
    int i_;
    int j_;
    double depth_;
    Reach across_;
    Reach down_;
    double leastSquared_ = std::numeric_limits<double>::infinity();
};

}  // namespace

textures::Plane buildConesBySquares(const textures::DepthMap& map,
                                    const std::function<void(std::size_t)>& advance, int step) {
    textures::Plane ratio((map.width() + step - 1) / step, (map.height() + step - 1) / step);
    tbb::parallel_for(0, ratio.height, [&](int j) {
        for (int i = 0; i < ratio.width; ++i) {
            const double texels = std::sqrt(SquareSearch(map, i * step, j * step).search());
            ratio.at(i, j) = roundDown(belowRounding(texels / map.width()));
        }
        if (advance)
            advance(static_cast<std::size_t>(ratio.width));
    });
    return ratio;
}

}  // namespace relievo::preprocess
