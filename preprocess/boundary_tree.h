#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace relievo::preprocess {

/// A straight piece of the boundary of a plane shape, in texels: x to the right, y downwards, the
/// first texel of the map from 0 to 1.
struct BoundarySegment {
    glm::dvec2 start{0.0};
    glm::dvec2 end{0.0};
};

/// Segments in a tree of boxes, halved along their longer side down to a few segments. For nearest
/// points of many places beside each other: boundary_distance.h.
struct BoundaryTree {
    /// Segments of a leaf, at most.
    static constexpr int kLeafSegments = 16;

    struct Node {
        // The box of all that is below, rounded outwards.
        float left;
        float top;
        float right;
        float bottom;
        /// Of a leaf its segments are [first, first + count); of others count is 0, one child is
        /// the next node and `first` the other.
        std::uint32_t first;
        std::uint32_t count;
    };

    /// What a search asks of a segment time and again: from start to end, and 1 / length² (0 for a
    /// point).
    struct Extent {
        float x;
        float y;
        float inverseSquare;
    };

    std::vector<Node> nodes;  ///< the root first; empty without segments
    std::vector<BoundarySegment> segments;
    std::vector<Extent> extents;  ///< of the segments
};

/// Builds the tree of segments of finite coordinates. n·log n; the same for the same segments.
BoundaryTree buildBoundaryTree(std::vector<BoundarySegment> segments);

}  // namespace relievo::preprocess
