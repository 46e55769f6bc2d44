#include "preprocess/cones_by_levels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "preprocess/distance_transform.h"
#include "preprocess/round_down.h"
#include "preprocess/step_progress.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;

std::vector<float> markedDepths(const Plane& depth, std::span<const std::uint8_t> marked) {
    std::vector<float> depths;
    for (std::size_t k = 0; k < marked.size(); ++k)
        if (marked[k] != 0)
            depths.push_back(depth.texels[k]);
    return depths;
}

// The least depth of each class of `depths`, ascending.
std::vector<float> leastDepths(std::vector<float> depths, int levels) {
    assert(levels >= 1);
    std::sort(depths.begin(), depths.end());
    depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
    if (depths.size() <= static_cast<std::size_t>(levels))
        return depths;
    const double first = depths.front();
    const double step = (depths.back() - first) / levels;
    const auto classOf = [&](float value) {
        return std::min(static_cast<int>((value - first) / step), levels - 1);
    };
    const auto last = std::unique(depths.begin(), depths.end(),
                                  [&](float a, float b) { return classOf(a) == classOf(b); });
    depths.erase(last, depths.end());
    return depths;
}

// Memory that is used again for each class.
struct Scratch {
    std::vector<std::uint8_t> set;
    SquaredDistances distances;
};

// Takes the minimum with the bound by one class: its marked texels and the higher ones are those
// less deep than `end`, all at least `least` deep.
void narrowByClass(const textures::DepthMap& map, std::span<const std::uint8_t> marked, float least,
                   float end, Scratch& scratch, Plane& ratio) {
    const std::vector<float>& depths = map.depth.texels;
    scratch.set.resize(depths.size());
    std::transform(depths.begin(), depths.end(), marked.begin(), scratch.set.begin(),
                   [end](float depth, std::uint8_t mark) {
                       return static_cast<std::uint8_t>(depth < end && mark != 0 ? 1 : 0);
                   });
    measureDistances(scratch.set, map.width(), map.height(), map.wrap, scratch.distances);
    // Distances are in steps of index: a safe bound where texels are not square.
    const double perStep = std::min(1.0, map.texelAspect) / map.width();
    const auto narrow = [&](std::size_t k) {
        // A texel may be in the class itself; the nearest other one is a texel away or more.
        const double squared = std::max(scratch.distances.texels[k], 1u);
        const double bound =
            std::sqrt(squared) * perStep / (static_cast<double>(depths[k]) - least);
        ratio.texels[k] = std::min(ratio.texels[k], roundDown(belowRounding(bound)));
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, depths.size()),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t k = range.begin(); k < range.end(); ++k)
                              if (depths[k] > least)
                                  narrow(k);
                      });
}

}  // namespace

Plane buildConesToTexels(const textures::DepthMap& map, std::span<const std::uint8_t> marked,
                         int levels, const std::function<void(std::size_t)>& advance) {
    const float unlimited = std::numeric_limits<float>::infinity();
    const std::vector<float> least = leastDepths(markedDepths(map.depth, marked), levels);
    Plane ratio(map.width(), map.height(), unlimited);
    StepProgress progress(advance, ratio.texels.size(), least.size());
    Scratch scratch;
    for (std::size_t k = 0; k < least.size(); ++k) {
        narrowByClass(map, marked, least[k], k + 1 < least.size() ? least[k + 1] : unlimited,
                      scratch, ratio);
        progress.done();
    }
    return ratio;
}

Plane buildConesByLevels(const textures::DepthMap& map, int levels,
                         const std::function<void(std::size_t)>& advance) {
    return buildConesToTexels(map, std::vector<std::uint8_t>(map.depth.texels.size(), 1), levels,
                              advance);
}

}  // namespace relievo::preprocess
