#include "preprocess/boundary_distance.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "preprocess/lanes.h"
#include "preprocess/processor.h"

namespace relievo::preprocess {
namespace {

constexpr int kBlock = 32;  // texels of a square whose segments are searched for in the tree
constexpr int kSquare = 8;  // texels of a square whose nearest segments are found at once
constexpr int kSquarePlaces = kSquare * kSquare;
static_assert(kBlock % kSquare == 0 && kLanes % kSquare == 0 && kSquarePlaces % kLanes == 0);

// Something convex, a segment or a box, as it is seen from a place.
struct Sight {
    float distance;
    float x = 0.0f;  // the unit vector from its nearest point to the place
    float y = 0.0f;

    Sight(float fromX, float fromY) : distance(std::sqrt(fromX * fromX + fromY * fromY)) {
        if (distance > 0.0f) {
            x = fromX / distance;
            y = fromY / distance;
        }
    }
};

// By how much farther than the nearest something may be from the middle of a disc and still be the
// nearest to another place of the disc, at x from the middle. The distance to something convex is
// convex: at least d + g·x, where d is that from the middle and g the unit vector of its sight. The
// distance to the nearest point of the nearest, sqrt(d² + 2d·g·x + x²), is at most
// d + g·x + x²/(2d). So what is by bend = r²/(2d) and |g − g'|·r farther is never nearer within the
// radius r; nor is what is by 2r farther.
struct Margin {
    float bend;
    float most;

    // With what floats may be off, for segments of up to 64 texels.
    Margin(const Sight& nearest, float radius) {
        const float off = 0x1p-18f * (nearest.distance + 2.0f * radius + 64.0f);
        bend = 0.5f * radius * radius / nearest.distance + off;
        most = 2.0f * radius + off;
    }
};

// Segments as floats, each of their values in a row of its own.
struct SegmentRows {
    float* startX;
    float* startY;
    float* alongX;
    float* alongY;
    float* inverseSquare;
    std::int32_t* number;
};

// Segments that may be the nearest to places of a square, in texels from the middle of its block.
class SegmentList {
  public:
    SegmentRows rows{};
    std::size_t count = 0;

    // Makes room for so many, and for what is written behind them.
    void reserve(std::size_t most) {
        if (most <= room_)
            return;
        room_ = 2 * most;
        const std::size_t length = room_ + kLanes;
        std::vector<float> values(5 * length);
        std::vector<std::int32_t> numbers(length);
        std::size_t row = 0;
        for (float** const start :
             {&rows.startX, &rows.startY, &rows.alongX, &rows.alongY, &rows.inverseSquare}) {
            std::copy_n(*start, count, &values[row]);
            *start = &values[row];
            row += length;
        }
        std::copy_n(rows.number, count, numbers.data());
        rows.number = numbers.data();
        values_ = std::move(values);
        numbers_ = std::move(numbers);
    }
    void add(const BoundaryTree& tree, std::uint32_t number, const glm::dvec2& middle) {
        const glm::dvec2 start = tree.segments[number].start - middle;
        const auto& [alongX, alongY, inverseSquare] = tree.extents[number];
        rows.startX[count] = static_cast<float>(start.x);
        rows.startY[count] = static_cast<float>(start.y);
        rows.alongX[count] = alongX;
        rows.alongY[count] = alongY;
        rows.inverseSquare[count] = inverseSquare;
        rows.number[count] = static_cast<std::int32_t>(number);
        ++count;
    }
    // It has so many. What is read behind them is endlessly far.
    void end(std::size_t count_) {
        constexpr float kFar = 1e30f;
        count = count_;
        std::fill_n(rows.startX + count, kLanes, kFar);
    }

  private:
    std::vector<float> values_;
    std::vector<std::int32_t> numbers_;
    std::size_t room_ = 0;
};

// Of the places of a square, row by row.
struct MeasuredSquare {
    float distance[kSquarePlaces];
    float awayX[kSquarePlaces];
    float awayY[kSquarePlaces];
};

}  // namespace
}  // namespace relievo::preprocess

#define RELIEVO_KERNEL "preprocess/boundary_distance_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {
namespace {

// To the left of the way from start to end.
glm::dvec2 normalOf(const BoundarySegment& segment) {
    const glm::dvec2 along = segment.end - segment.start;
    const double length = glm::length(along);
    return length > 0.0 ? glm::dvec2(along.y, -along.x) / length : glm::dvec2(0.0, -1.0);
}

// From the nearest point of a box to a place.
glm::vec2 awayFrom(const BoundaryTree::Node& node, const glm::vec2& place) {
    return {place.x - std::clamp(place.x, node.left, node.right),
            place.y - std::clamp(place.y, node.top, node.bottom)};
}

float squareOf(const glm::vec2& way) {
    return glm::dot(way, way);
}

// Of the disc around the texel centres of a square.
constexpr float radiusOf(int side) {
    return 0.70711f * static_cast<float>(side - 1);
}

// The search of one block of texels after the other.
class BlockSearch {
  public:
    BlockSearch(const BoundaryTree& tree, BoundaryDistances& distances)
        : tree_(tree), distances_(distances) {}

    // The block whose first texel is (i,j).
    void measure(int i, int j) {
        middle_ = glm::dvec2(i, j) + 0.5 * kBlock;
        collect();
        measureWithin(i, j, kBlock, 0);
    }

  private:
    // The nearest to the middle of the block, searched for from the nearest to the last one on.
    [[nodiscard]] Sight findNearest() {
        float least = std::numeric_limits<float>::infinity();
        glm::vec2 nearest(0.0f);
        const auto look = [&](std::uint32_t number) {
            const auto& [alongX, alongY, inverse] = tree_.extents[number];
            const glm::vec2 along(alongX, alongY);
            const glm::vec2 to(middle_ - tree_.segments[number].start);
            const glm::vec2 away =
                to - std::clamp(glm::dot(to, along) * inverse, 0.0f, 1.0f) * along;
            if (squareOf(away) < least) {
                least = squareOf(away);
                nearest = away;
                seed_ = number;
            }
        };
        look(seed_);
        const glm::vec2 middle(middle_);
        stack_ = {0};
        while (!stack_.empty()) {
            const std::uint32_t number = stack_.back();
            const BoundaryTree::Node& node = tree_.nodes[number];
            stack_.pop_back();
            if (squareOf(awayFrom(node, middle)) >= least)
                continue;
            for (std::uint32_t k = 0; k < node.count; ++k)
                look(node.first + k);
            if (node.count == 0)
                pushChildren(number, middle);
        }
        return Sight(nearest.x, nearest.y);
    }

    // The nearer one is looked at first.
    void pushChildren(std::uint32_t number, const glm::vec2& place) {
        std::uint32_t first = number + 1;
        std::uint32_t second = tree_.nodes[number].first;
        if (squareOf(awayFrom(tree_.nodes[second], place)) <
            squareOf(awayFrom(tree_.nodes[first], place)))
            std::swap(first, second);
        stack_.push_back(second);
        stack_.push_back(first);
    }

    // All that may be the nearest to a place of the block.
    void collect() {
        constexpr float kRadius = radiusOf(kBlock);
        const Sight nearest = findNearest();
        const Margin margin(nearest, kRadius);
        const auto isFar = [&](const BoundaryTree::Node& node) {
            const glm::vec2 away = awayFrom(node, glm::vec2(middle_));
            const Sight sight(away.x, away.y);
            const float farther = sight.distance - nearest.distance;
            const float beyond = farther - margin.bend;
            const glm::vec2 turn(sight.x - nearest.x, sight.y - nearest.y);
            return farther > margin.most ||
                   (beyond > 0.0f && beyond * beyond > kRadius * kRadius * squareOf(turn));
        };
        SegmentList& list = lists_[0];
        list.count = 0;
        stack_ = {0};
        while (!stack_.empty()) {
            const std::uint32_t number = stack_.back();
            const BoundaryTree::Node& node = tree_.nodes[number];
            stack_.pop_back();
            if (isFar(node))
                continue;
            list.reserve(list.count + node.count);
            for (std::uint32_t k = 0; k < node.count; ++k)
                list.add(tree_, node.first + k, middle_);
            if (node.count == 0)
                stack_.insert(stack_.end(), {node.first, number + 1});
        }
        list.end(list.count);
    }

    // The square whose first texel is (i,j), with the list of this level. As long as a list is long
    // enough to be worth it, the quarters of a square have their own.
    void measureWithin(int i, int j, int side, std::size_t level) {
        if (i >= distances_.distance.width || j >= distances_.distance.height)
            return;
        if (side == kSquare) {
            measureSquare(i, j, lists_[level]);
            return;
        }
        const int half = side / 2;
        for (const auto& [x, y] :
             {std::pair{i, j}, {i + half, j}, {i, j + half}, {i + half, j + half}}) {
            std::size_t next = level;
            if (lists_[level].count > kLanes) {
                ++next;
                lists_[next].reserve(lists_[level].count);
                RELIEVO_CALL_KERNEL(
                    keepNearest, lists_[level], static_cast<float>(x + 0.5 * half - middle_.x),
                    static_cast<float>(y + 0.5 * half - middle_.y), radiusOf(half), lists_[next]);
            }
            measureWithin(x, y, half, next);
        }
    }

    void measureSquare(int i, int j, const SegmentList& list) {
        std::int32_t numbers[kSquarePlaces];
        MeasuredSquare measured;
        RELIEVO_CALL_KERNEL(findNearest, tree_, list, i, j, numbers);
        RELIEVO_CALL_KERNEL(measurePlaces, tree_, i, j, numbers, measured);
        for (int k = 0; k < kSquarePlaces; ++k)
            if (measured.distance[k] == 0.0f) {
                const glm::dvec2 away =
                    normalOf(tree_.segments[static_cast<std::size_t>(numbers[k])]);
                measured.awayX[k] = static_cast<float>(away.x);
                measured.awayY[k] = static_cast<float>(away.y);
            }
        store(measured.distance, i, j, distances_.distance);
        store(measured.awayX, i, j, distances_.awayX);
        store(measured.awayY, i, j, distances_.awayY);
    }

    static void store(const float* values, int i, int j, textures::Plane& plane) {
        const int columns = std::min(kSquare, plane.width - i);
        for (int row = j; row < std::min(j + kSquare, plane.height); ++row, values += kSquare)
            if (columns == kSquare)  // what the compiler knows to be short takes two instructions
                std::copy_n(values, kSquare, &plane.at(i, row));
            else
                std::copy_n(values, columns, &plane.at(i, row));
    }

    const BoundaryTree& tree_;
    BoundaryDistances& distances_;
    glm::dvec2 middle_{0.0};  // of the block
    std::uint32_t seed_ = 0;
    std::vector<std::uint32_t> stack_;
    std::array<SegmentList, 3> lists_;  // of squares of half the side each
};

void measureBand(const BoundaryTree& tree, int top, BoundaryDistances& distances) {
    BlockSearch search(tree, distances);
    for (int i = 0; i < distances.distance.width; i += kBlock)
        search.measure(i, top);
}

}  // namespace

BoundaryDistances measureBoundaryDistances(const BoundaryTree& tree, int width, int height,
                                           const RowsMeasured& rowsMeasured) {
    using textures::Plane;
    BoundaryDistances distances;
    // Memory is touched for the first time here, which takes longer than to fill it.
    tbb::parallel_invoke(
        [&] { distances.distance = Plane(width, height, std::numeric_limits<float>::infinity()); },
        [&] { distances.awayX = Plane(width, height); },
        [&] { distances.awayY = Plane(width, height); });
    if (tree.nodes.empty())
        return distances;
    tbb::parallel_for(0, (height + kBlock - 1) / kBlock, [&](int band) {
        const int first = band * kBlock;
        measureBand(tree, first, distances);
        if (rowsMeasured)
            rowsMeasured(distances, first, std::min(first + kBlock, height));
    });
    return distances;
}

}  // namespace relievo::preprocess
