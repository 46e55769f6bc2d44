#include "preprocess/boundary_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace relievo::preprocess {
namespace {

struct Box {
    glm::dvec2 least{std::numeric_limits<double>::infinity()};
    glm::dvec2 most{-std::numeric_limits<double>::infinity()};
};

Box boxOf(std::span<const BoundarySegment> segments) {
    Box box;
    for (const BoundarySegment& segment : segments)
        for (int axis = 0; axis < 2; ++axis) {
            box.least[axis] = std::min({box.least[axis], segment.start[axis], segment.end[axis]});
            box.most[axis] = std::max({box.most[axis], segment.start[axis], segment.end[axis]});
        }
    return box;
}

float roundedOutwards(double value, float towards) {
    const auto rounded = static_cast<float>(value);
    return std::nextafter(rounded, towards);
}

BoundaryTree::Node nodeOf(const Box& box) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    return {roundedOutwards(box.least.x, -kInfinity),
            roundedOutwards(box.least.y, -kInfinity),
            roundedOutwards(box.most.x, kInfinity),
            roundedOutwards(box.most.y, kInfinity),
            0,
            0};
}

// How many nodes a tree of so many segments has: halved d times they are in 2ᵈ parts, of which as
// many as the rest of the division has one more than the others.
std::size_t nodesOf(std::size_t segments) {
    std::size_t parts = 1;
    while (segments / parts > BoundaryTree::kLeafSegments)
        parts *= 2;
    const bool isFull = segments / parts == BoundaryTree::kLeafSegments;
    return 2 * parts - 1 + 2 * (isFull ? segments % parts : 0);
}

// Makes the tree of segments [first, last), whose root is node `number`.
void build(BoundaryTree& tree, std::size_t number, std::size_t first, std::size_t last) {
    constexpr std::size_t kManySegments = 1024;  // worth another task
    const std::span<BoundarySegment> all(tree.segments);
    const std::span<BoundarySegment> part = all.subspan(first, last - first);
    const Box box = boxOf(part);
    BoundaryTree::Node& node = tree.nodes[number];
    node = nodeOf(box);
    if (part.size() <= BoundaryTree::kLeafSegments) {
        node.first = static_cast<std::uint32_t>(first);
        node.count = static_cast<std::uint32_t>(part.size());
        return;
    }
    const int axis = box.most.x - box.least.x >= box.most.y - box.least.y ? 0 : 1;
    const std::size_t half = part.size() / 2;
    std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                     [axis](const BoundarySegment& a, const BoundarySegment& b) {
                         return a.start[axis] + a.end[axis] < b.start[axis] + b.end[axis];
                     });
    const std::size_t second = number + 1 + nodesOf(half);
    node.first = static_cast<std::uint32_t>(second);
    const auto buildFirst = [&] { build(tree, number + 1, first, first + half); };
    const auto buildSecond = [&] { build(tree, second, first + half, last); };
    if (part.size() >= kManySegments) {
        tbb::parallel_invoke(buildFirst, buildSecond);
    } else {
        buildFirst();
        buildSecond();
    }
}

BoundaryTree::Extent extentOf(const BoundarySegment& segment) {
    const auto x = static_cast<float>(segment.end.x - segment.start.x);
    const auto y = static_cast<float>(segment.end.y - segment.start.y);
    const float square = x * x + y * y;
    return {x, y, square > 0.0f ? 1.0f / square : 0.0f};
}

}  // namespace

BoundaryTree buildBoundaryTree(std::vector<BoundarySegment> segments) {
    BoundaryTree tree;
    tree.segments = std::move(segments);
    if (!tree.segments.empty()) {
        tree.nodes.resize(nodesOf(tree.segments.size()));
        build(tree, 0, 0, tree.segments.size());
    }
    tree.extents.resize(tree.segments.size());
    std::ranges::transform(tree.segments, tree.extents.begin(), extentOf);
    return tree;
}

}  // namespace relievo::preprocess
