#include "preprocess/distance_volume.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "preprocess/dilation_erosion.h"
#include "preprocess/round_down.h"
#include "preprocess/step_progress.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

// Columns of texels that a thread copies side by side: a cache line of doubles.
constexpr int kStripe = 8;
constexpr int kGrain = 16;

// The least depth of the surface over the square of a texel. Its quarters are pieces of one
// bilinear patch each, which are bounded by their corners.
float leastInSquare(const DepthMap& map, int i, int j) {
    double least = map.at(i, j);
    for (const int y : {j - 1, j + 1})
        for (const int x : {i - 1, i + 1}) {
            const double centre = map.at(i, j);
            const double beside = map.at(x, j);
            const double under = map.at(i, y);
            const double across = map.at(x, y);
            least = std::min({least, (centre + beside) / 2, (centre + under) / 2,
                              (centre + beside + under + across) / 4});
        }
    return roundDown(least);
}

// The least depth over the squares of a texel and its neighbours: what is beside a voxel is as near
// as what is below it.
Plane leastAround(const DepthMap& map) {
    DepthMap least{Plane(map.width(), map.height()), map.wrap, map.texelAspect};
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int i = 0; i < map.width(); ++i)
            least.depth.at(i, j) = leastInSquare(map, i, j);
    });
    return findDepthExtrema(least, 1).least;
}

// The lower envelope of parabolas (x − p)² + values[p] at whole x.
class ParabolaEnvelope {
  public:
    explicit ParabolaEnvelope(int length)
        : heights_(static_cast<std::size_t>(length) + 1), parabolas_(heights_.size() + 1) {}

    // Replaces values[x] by the least over all p, and with `repeats` over all copies of the values.
    // A parabola with the least height is lower than all behind it, so that no more of them is
    // needed than one period between two copies of that one.
    void apply(std::span<double> values, bool repeats) {
        const auto first =
            repeats ? std::min_element(values.begin(), values.end()) : values.begin();
        std::rotate_copy(values.begin(), first, values.end(), heights_.begin());
        const std::size_t count = values.size() + (repeats ? 1 : 0);
        heights_[values.size()] = *first;
        build(count);
        const auto shift = static_cast<std::size_t>(first - values.begin());
        const Parabola* lowest = parabolas_.data();
        for (std::size_t x = 0; x < values.size(); ++x) {
            while (lowest[1].start <= static_cast<double>(x))
                ++lowest;
            const double across = static_cast<double>(x) - lowest->place;
            values[(x + shift) % values.size()] = across * across + lowest->height;
        }
    }

  private:
    struct Parabola {
        double place;
        double height;
        double start;  // the lowest from here on
    };

    void build(std::size_t count) {
        std::size_t size = 0;
        for (std::size_t p = 0; p < count; ++p) {
            Parabola next{static_cast<double>(p), heights_[p],
                          -std::numeric_limits<double>::infinity()};
            for (; size > 0; --size) {
                next.start = crossing(parabolas_[size - 1], next);
                if (next.start > parabolas_[size - 1].start)
                    break;
            }
            parabolas_[size++] = next;
        }
        parabolas_[size].start = std::numeric_limits<double>::infinity();
    }

    // Where `b`, to the right of `a`, becomes the lower one.
    static double crossing(const Parabola& a, const Parabola& b) {
        return ((b.height - a.height) / (b.place - a.place) + a.place + b.place) / 2;
    }

    std::vector<double> heights_;
    std::vector<Parabola> parabolas_;
};

// Lengths in texel widths.
struct Slice {
    double bottom;      // the depth of its voxels' bottoms
    double depthScale;  // of a depth of 1
    double aspect;      // height of a texel
    bool repeats;
};

void measureRows(const Plane& least, const Slice& slice, std::vector<double>& squared) {
    const auto width = static_cast<std::size_t>(least.width);
    tbb::parallel_for(tbb::blocked_range<int>(0, least.height, kGrain), [&](const auto& rows) {
        ParabolaEnvelope envelope(least.width);
        for (int j = rows.begin(); j < rows.end(); ++j) {
            const std::span<double> row =
                std::span(squared).subspan(static_cast<std::size_t>(j) * width, width);
            for (int i = 0; i < least.width; ++i) {
                const double under =
                    std::max(0.0, slice.depthScale * (least.at(i, j) - slice.bottom));
                row[static_cast<std::size_t>(i)] = under * under;
            }
            envelope.apply(row, slice.repeats);
        }
    });
}

// From squared distances along rows to distances in tile widths.
void measureColumns(const std::vector<double>& squared, const Slice& slice, Plane& distances) {
    const auto width = static_cast<std::size_t>(distances.width);
    const auto height = static_cast<std::size_t>(distances.height);
    const double aspect = slice.aspect * slice.aspect;
    // Crossings are off by some epsilons of their place, so that the next lowest may be taken.
    const double span = static_cast<double>(std::max(width, height)) * std::max(1.0, slice.aspect);
    const double rounding = 32.0 * std::numeric_limits<double>::epsilon() *
                            (span * span + slice.depthScale * slice.depthScale);
    const int stripes = (distances.width + kStripe - 1) / kStripe;
    tbb::parallel_for(tbb::blocked_range<int>(0, stripes), [&](const auto& range) {
        ParabolaEnvelope envelope(distances.height);
        std::vector<double> columns(height * kStripe);
        for (int stripe = range.begin(); stripe < range.end(); ++stripe) {
            const std::size_t left = static_cast<std::size_t>(stripe) * kStripe;
            const std::size_t count = std::min<std::size_t>(kStripe, width - left);
            for (std::size_t j = 0; j < height; ++j)
                for (std::size_t k = 0; k < count; ++k)
                    columns[k * height + j] = squared[j * width + left + k] / aspect;
            for (std::size_t k = 0; k < count; ++k)
                envelope.apply(std::span(columns).subspan(k * height, height), slice.repeats);
            for (std::size_t j = 0; j < height; ++j)
                for (std::size_t k = 0; k < count; ++k) {
                    const double safe = columns[k * height + j] * aspect - rounding;
                    distances.texels[j * width + left + k] = roundDown(
                        belowRounding(std::sqrt(std::max(safe, 0.0))) / static_cast<double>(width));
                }
        }
    });
}

}  // namespace

std::vector<Plane> buildDistanceVolume(const DepthMap& map, int slices, double depthScale,
                                       const std::function<void(std::size_t)>& advance) {
    assert(slices >= 1 && depthScale > 0.0);
    const Plane least = leastAround(map);
    std::vector<double> squared(map.depth.texels.size());
    std::vector<Plane> volume;
    StepProgress progress(advance, squared.size(), static_cast<std::size_t>(slices));
    for (int k = 0; k < slices; ++k) {
        // Mirrored and clamped tiles need no copies: their nearest column is the tile's own.
        const Slice slice{static_cast<double>(k + 1) / slices, depthScale * map.width(),
                          map.texelAspect, map.wrap == WrapMode::Repeat};
        measureRows(least, slice, squared);
        measureColumns(squared, slice, volume.emplace_back(map.width(), map.height()));
        progress.done();
    }
    return volume;
}

}  // namespace relievo::preprocess
