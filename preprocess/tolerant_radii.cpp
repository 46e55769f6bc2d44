#include "preprocess/tolerant_radii.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "preprocess/dilation_erosion.h"
#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Differences of depths are rounded to floats.
constexpr double kRounding = std::numeric_limits<float>::epsilon();

// A map whose differences of neighbours continue outside as the map does: they change their signs
// where it is mirrored, and vanish beyond the border where it is clamped.
struct Layout {
    DepthMap map;
    int border;  // where the tile begins
};

Layout layOut(const DepthMap& map) {
    const int border = map.wrap == WrapMode::Clamp ? 1 : 0;
    const int tiles = map.wrap == WrapMode::Mirror ? 2 : 1;
    DepthMap wide{Plane(tiles * map.width() + 2 * border, tiles * map.height() + 2 * border),
                  border > 0 ? WrapMode::Clamp : WrapMode::Repeat, map.texelAspect};
    tbb::parallel_for(0, wide.height(), [&](int j) {
        for (int i = 0; i < wide.width(); ++i)
            wide.depth.at(i, j) = map.at(i - border, j - border);
    });
    return {std::move(wide), border};
}

// Along u for (1,0), along v for (0,1).
DepthMap differencesOf(const DepthMap& map, int alongU, int alongV) {
    DepthMap differences{Plane(map.width(), map.height()), map.wrap, map.texelAspect};
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int i = 0; i < map.width(); ++i)
            differences.depth.at(i, j) = map.at(i + alongU, j + alongV) - map.at(i, j);
    });
    return differences;
}

// Adds to each texel of the tile the square of the most that slopes along one axis differ by in its
// window, in depth per texel width. Differences belong to the texel before them, so that the window
// has one more than it needs.
void addSquaredSpans(const Layout& layout, int alongU, int alongV, int window, Plane& squares) {
    const DepthExtrema extrema =
        findDepthExtrema(differencesOf(layout.map, alongU, alongV), window);
    const double length = alongU == 1 ? 1.0 : layout.map.texelAspect;
    tbb::parallel_for(0, squares.height, [&](int j) {
        for (int i = 0; i < squares.width; ++i) {
            const double least = extrema.least.at(i + layout.border, j + layout.border);
            const double greatest = extrema.greatest.at(i + layout.border, j + layout.border);
            const double span =
                (greatest - least + kRounding * (std::abs(greatest) + std::abs(least))) / length;
            squares.at(i, j) += static_cast<float>(span * span);
        }
    });
}

// Widens radii, in texel widths, to what windows of `reach` texel widths allow; whether larger
// windows may allow more.
bool widen(const Plane& squaredSpans, double tolerance, double reach, Plane& radii) {
    std::atomic<bool> mayGrow = false;
    tbb::parallel_for(0, radii.height, [&](int j) {
        for (int i = 0; i < radii.width; ++i) {
            const double span = std::sqrt(squaredSpans.at(i, j) * (1.0 + 4.0 * kRounding));
            const double limit = span > 0.0 ? 4.0 * tolerance / span : kInfinity;
            radii.at(i, j) =
                std::max(radii.at(i, j), roundDown(belowRounding(std::min(limit, reach))));
            if (limit > reach)
                mayGrow = true;
        }
    });
    return mayGrow;
}

}  // namespace

Plane buildTolerantRadii(const DepthMap& map, double tolerance) {
    assert(tolerance > 0.0);
    const Layout layout = layOut(map);
    const int whole = std::max(layout.map.width(), layout.map.height());
    Plane radii(map.width(), map.height());
    bool mayGrow = true;
    for (int window = 1; mayGrow; window += std::max(1, window / 2)) {
        // Beyond the whole map nothing new comes. The square reaches half a texel from the centre.
        const double reach =
            window >= whole ? kInfinity : (window - 0.5) * std::min(1.0, map.texelAspect);
        Plane squaredSpans(map.width(), map.height());
        addSquaredSpans(layout, 1, 0, window, squaredSpans);
        addSquaredSpans(layout, 0, 1, window, squaredSpans);
        mayGrow = widen(squaredSpans, tolerance, reach, radii);
    }
    for (float& radius : radii.texels)
        radius = roundDown(belowRounding(static_cast<double>(radius) / map.width()));
    return radii;
}

}  // namespace relievo::preprocess
