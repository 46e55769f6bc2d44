#include "preprocess/bilinear_cones.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "preprocess/bilinear_slopes.h"
#include "preprocess/block_loop.h"
#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;

// Samples in this window around a corner of a texel's square belong, with all cells beside them, to
// the near chords of the square.
constexpr float kCornerWindow = BilinearSlopes::kReach - 1.75f;
// An edited sample changes the near chords of the texels this far from it: their reach, and a texel
// for the patches on both sides.
constexpr int kNearInfluence = BilinearSlopes::kReach + 2;
// Far slopes are rounded up by 1/64 at most, 1/128 in the mean.
constexpr int kFarBits = 6;
// Slopes are products and quotients of a handful of floats.
constexpr double kSlopeRounding = 3e-7;
// Depths between samples are rounded to floats of a depth up to 1: so much slope may be lost over
// an eighth of a texel.
constexpr double kDepthRounding = 1.5e-6;

// κ of bilinear_slopes.h for squares of apexes and cells of samples, of one texel each.
float cornerCorrection(double aspect) {
    return static_cast<float>(0.5 * (1.0 + aspect * aspect));
}

SlopeSearchRules farRules(double aspect) {
    return {.window = kCornerWindow, .correction = cornerCorrection(aspect), .bits = kFarBits};
}

// What a chord must be steeper than to be rounded up to at least `slope`, a number as the search
// rounds them: the one below it.
float numberBelow(float slope) {
    constexpr std::uint32_t kStep = 1u << (23 - kFarBits);
    return slope > 0.0f ? std::bit_cast<float>(std::bit_cast<std::uint32_t>(slope) - kStep) : 0.0f;
}

// What a thread works with.
struct Worker {
    BilinearSlopes near;
    SlopeSearch search;
    ApexBlock apexes;
    BlockValues slopes;
    Worker(const ReliefTree& tree, const DepthMap& map)
        : near(map.texelAspect),
          search(tree, map.wrap, map.texelAspect, farRules(map.texelAspect)) {}
};

// The distance of `position` from the places first…last of an axis, and from their copies.
float axisGap(float position, int first, int last, int size, textures::WrapMode wrap) {
    const auto gapTo = [&](int copy) {
        return std::max({static_cast<float>(first + copy) - position,
                         position - static_cast<float>(last + copy), 0.0f});
    };
    const float gap = gapTo(0);
    return wrap == textures::WrapMode::Repeat ? std::min({gap, gapTo(-size), gapTo(size)}) : gap;
}

// Marks on a grid.
struct MarkGrid {
    int width;
    int height;
    std::vector<std::uint8_t> marks;
    MarkGrid(int columns, int rows, bool mark)
        : width(columns),
          height(rows),
          marks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), mark ? 1 : 0) {}
    [[nodiscard]] std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(i);
    }
    [[nodiscard]] bool at(int i, int j) const { return marks[index(i, j)] != 0; }
    void mark(int i, int j) { marks[index(i, j)] = 1; }
    void unmark(int i, int j) { marks[index(i, j)] = 0; }
    [[nodiscard]] const std::uint8_t* row(int j) const { return &marks[index(0, j)]; }
    // Those in a block that have a mark.
    [[nodiscard]] BlockGroups groupsIn(const BlockPlace& place) const {
        const auto hasMark = [&](int i, int j, int count) {
            return std::memchr(row(place.top + j) + place.left + i, 1,
                               static_cast<std::size_t>(count)) != nullptr;
        };
        BlockGroups groups{};
        for (int j = 0; j < place.height; ++j)
            if (hasMark(0, j, place.width))
                for (int i = 0; i < place.width; i += kLanes)
                    groups[blockIndex(i, j) / kLanes] =
                        hasMark(i, j, std::min(kLanes, place.width - i));
        return groups;
    }
};

bool hasAny(const BlockGroups& groups) {
    return std::ranges::find(groups, true) != groups.end();
}

}  // namespace

// What is to be built.
struct BilinearCones::Marks {
    MarkGrid texels;
    MarkGrid corners;
    Marks(int width, int height, bool mark)
        : texels(width, height, mark), corners(width + 1, height + 1, mark) {}

    // Marks the texels whose squares have a marked corner.
    void addSquares() {
        tbb::parallel_for(0, texels.height, [&](int j) {
            const std::uint8_t* const above = corners.row(j);
            const std::uint8_t* const below = corners.row(j + 1);
            std::uint8_t* const here = &texels.marks[texels.index(0, j)];
            for (int i = 0; i < texels.width; ++i)
                here[i] = here[i] | above[i] | above[i + 1] | below[i] | below[i + 1];
        });
    }
};

struct BilinearCones::Workers {
    tbb::enumerable_thread_specific<Worker> ofThreads;
};

BilinearCones::~BilinearCones() = default;

BilinearCones::BilinearCones(DepthMap map, const std::function<void(std::size_t)>& advance,
                             SlopeSearchStatistics* statistics)
    : map_(std::move(map)),
      tree_(buildReliefTree(map_.depth)),
      coarse_(map_.width(), map_.height()),
      cornerDepth_(map_.width() + 1, map_.height() + 1),
      corner_(map_.width() + 1, map_.height() + 1),
      ratio_(map_.width(), map_.height()),
      workers_(new Workers{
          tbb::enumerable_thread_specific<Worker>([this] { return Worker(tree_, map_); })}) {
    Marks marks(map_.width(), map_.height(), true);
    build(marks, advance);
    collect(workers_->ofThreads, statistics);
}

void BilinearCones::build(Marks& marks, const std::function<void(std::size_t)>& advance) {
    findCoarse(marks);
    findCorners(marks);
    marks.addSquares();
    refine(marks, advance);
}

void BilinearCones::findCoarse(const Marks& marks) {
    forAllBlocks(map_.width(), map_.height(), workers_->ofThreads,
                 [&](Worker& state, const BlockPlace& place) {
                     const BlockGroups wanted = marks.texels.groupsIn(place);
                     if (!hasAny(wanted))
                         return;
                     state.near.begin(map_, place.left, place.top);
                     state.near.findCoarse(wanted, state.slopes);
                     forTexels(place, [&](int i, int j, std::size_t k) {
                         if (marks.texels.at(i, j))
                             coarse_.at(i, j) = state.slopes[k];
                     });
                 });
}

// The least slope known in the four squares around a corner.
float BilinearCones::knownAround(int i, int j) const {
    float known = std::numeric_limits<float>::infinity();
    for (const int y : {j - 1, j})
        for (const int x : {i - 1, i})
            known = std::min(known, coarse_.at(textures::wrapIndex(x, map_.width(), map_.wrap),
                                               textures::wrapIndex(y, map_.height(), map_.wrap)));
    return known;
}

// Leaves those corners marked whose slopes changed.
void BilinearCones::findCorners(Marks& marks) {
    forAllBlocks(corner_.width, corner_.height, workers_->ofThreads,
                 [&](Worker& state, const BlockPlace& place) {
                     const BlockGroups wanted = marks.corners.groupsIn(place);
                     if (!hasAny(wanted))
                         return;
                     state.near.begin(map_, place.left, place.top);
                     state.near.findCornerDepths(wanted, state.apexes.depth);
                     state.apexes.left = static_cast<float>(place.left) - 0.5f;
                     state.apexes.top = static_cast<float>(place.top) - 0.5f;
                     state.apexes.width = place.width;
                     state.apexes.height = place.height;
                     forTexels(place, [&](int i, int j, std::size_t k) {
                         state.apexes.known[k] = knownAround(i, j);
                         // Nothing rises from depth 0: no search where there is no need.
                         if (marks.corners.at(i, j))
                             cornerDepth_.at(i, j) = state.apexes.depth[k];
                         else
                             state.apexes.depth[k] = 0.0f;
                     });
                     findSlopes(state.search, state.apexes, state.slopes);
                     forTexels(place, [&](int i, int j, std::size_t k) {
                         if (!marks.corners.at(i, j))
                             return;
                         if (corner_.at(i, j) == state.slopes[k])
                             marks.corners.unmark(i, j);
                         corner_.at(i, j) = state.slopes[k];
                     });
                 });
}

void BilinearCones::refine(const Marks& marks, const std::function<void(std::size_t)>& advance) {
    forAllBlocks(map_.width(), map_.height(), workers_->ofThreads,
                 [&](Worker& state, const BlockPlace& place) {
                     const BlockGroups wanted = marks.texels.groupsIn(place);
                     if (!hasAny(wanted))
                         return;
                     state.near.begin(map_, place.left, place.top);
                     forTexels(place, [&](int i, int j, std::size_t k) {
                         state.slopes[k] =
                             std::max({coarse_.at(i, j), corner_.at(i, j), corner_.at(i + 1, j),
                                       corner_.at(i, j + 1), corner_.at(i + 1, j + 1)});
                     });
                     state.near.refine(wanted, state.slopes);
                     forTexels(place, [&](int i, int j, std::size_t k) {
                         if (!marks.texels.at(i, j))
                             return;
                         const double known = state.slopes[k];
                         const double safe =
                             known > 0.0 ? known * (1.0 + kSlopeRounding) + kDepthRounding : 0.0;
                         ratio_.at(i, j) = ratioOfSlope(safe, map_.width());
                     });
                     if (advance)
                         advance(place.texels());
                 });
}

// Marks the corners, and the squares around them, whose near chords the samples of the rectangle
// may change.
void BilinearCones::markNear(const TexelRectangle& rectangle, Marks& marks) const {
    const auto isNear = [&](int corner, int first, int length, int size) {
        return axisGap(static_cast<float>(corner) - 0.5f, first, first + length - 1, size,
                       map_.wrap) <= static_cast<float>(kNearInfluence);
    };
    for (int j = 0; j < corner_.height; ++j)
        if (isNear(j, rectangle.top, rectangle.height, map_.height()))
            for (int i = 0; i < corner_.width; ++i)
                if (isNear(i, rectangle.left, rectangle.width, map_.width()))
                    marks.corners.mark(i, j);
    marks.addSquares();
}

// Marks the corners whose far slopes the samples of the rectangle may set, or may have set: those
// that no chord there, to the least depth it has or had, can be as steep as.
void BilinearCones::markReached(const TexelRectangle& rectangle, float leastDepth,
                                Marks& marks) const {
    const int right = rectangle.left + rectangle.width - 1;
    const int bottom = rectangle.top + rectangle.height - 1;
    const auto aspect = static_cast<float>(map_.texelAspect);
    const float correction = cornerCorrection(map_.texelAspect);
    std::vector<float> across(static_cast<std::size_t>(corner_.width));
    for (int i = 0; i < corner_.width; ++i) {
        const float gap =
            axisGap(static_cast<float>(i) - 0.5f, rectangle.left, right, map_.width(), map_.wrap);
        across[static_cast<std::size_t>(i)] = gap * gap;
    }
    tbb::parallel_for(0, corner_.height, [&](int j) {
        const float gap =
            axisGap(static_cast<float>(j) - 0.5f, rectangle.top, bottom, map_.height(), map_.wrap);
        const float down = gap * gap * aspect * aspect - correction;
        const std::size_t first = corner_.index(0, j);
        const float* const depths = &cornerDepth_.texels[first];
        const float* const slopes = &corner_.texels[first];
        std::uint8_t* const here = &marks.corners.marks[first];
        for (std::size_t i = 0; i < across.size(); ++i) {
            const float difference = (depths[i] - leastDepth) * (1.0f + 2e-6f);
            const float slope = numberBelow(slopes[i]);
            const bool mayChange = (difference > 0.0f) &
                                   (difference * difference > slope * slope * (across[i] + down));
            here[i] = here[i] | static_cast<std::uint8_t>(mayChange);
        }
    });
}

std::size_t BilinearCones::edit(int left, int top, const Plane& depths) {
    const TexelRectangle rectangle{left, top, depths.width, depths.height};
    assert(left >= 0 && top >= 0 && left + depths.width <= map_.width() &&
           top + depths.height <= map_.height());
    float least = std::numeric_limits<float>::infinity();
    for (int j = 0; j < depths.height; ++j)
        for (int i = 0; i < depths.width; ++i) {
            float& depth = map_.depth.at(left + i, top + j);
            if (depth == depths.at(i, j))
                continue;
            least = std::min({least, depth, depths.at(i, j)});
            depth = depths.at(i, j);
        }
    if (std::isinf(least))
        return 0;  // nothing changed
    updateReliefTree(tree_, map_.depth, rectangle);
    Marks marks(map_.width(), map_.height(), false);
    markNear(rectangle, marks);
    markReached(rectangle, least, marks);
    build(marks, {});
    return static_cast<std::size_t>(std::ranges::count(marks.texels.marks, std::uint8_t{1}));
}

}  // namespace relievo::preprocess
