#include "preprocess/boundary_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <limits>

#include "preprocess/lanes.h"
#include "preprocess/processor.h"

namespace relievo::preprocess {
namespace {

constexpr int kSide = 4;  // texels of a packet
static_assert(kSide * kSide == kLanes);
constexpr int kBlock = 32;  // texels of a block of packets that begin at the same nodes
static_assert(kBlock % kSide == 0);

// Where a search down the tree begins: at the root, or at nodes below which all is that counts.
struct StartNodes {
    static constexpr int kMost = 16;
    std::array<std::uint32_t, kMost> nodes{0};
    int count = 1;
};

// Places in texels from the origin, and what was found nearest to each.
struct NearestPacket {
    double originX;
    double originY;
    float middle;  // of the places along both axes
    Lanes x;
    Lanes y;
    Lanes square;      // of the distance
    LaneMask segment;  // its number; −1: none
};

// What the packet's places are told, in double precision: of each the segment that is nearest,
// relative to it, and then the distance and the unit vector away from it.
struct PacketAnswer {
    std::array<double, kLanes> toX;
    std::array<double, kLanes> toY;
    std::array<double, kLanes> alongX;
    std::array<double, kLanes> alongY;
    std::array<double, kLanes> distance;
    std::array<double, kLanes> awayX;
    std::array<double, kLanes> awayY;
};

}  // namespace
}  // namespace relievo::preprocess

#define RELIEVO_KERNEL "preprocess/boundary_distance_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {
namespace {

NearestPacket packetAt(int i, int j) {
    NearestPacket packet{
        static_cast<double>(i), static_cast<double>(j), 0.5f * kSide, {}, {}, {}, {}};
    for (int k = 0; k < kLanes; ++k) {
        packet.x[k] = static_cast<float>(k % kSide) + 0.5f;
        packet.y[k] = static_cast<float>(k / kSide) + 0.5f;
        packet.square[k] = std::numeric_limits<float>::infinity();
        packet.segment[k] = -1;
    }
    return packet;
}

// To the left of the way from start to end.
glm::dvec2 normalOf(const BoundarySegment& segment) {
    const glm::dvec2 along = segment.end - segment.start;
    const double length = glm::length(along);
    return length > 0.0 ? glm::dvec2(along.y, -along.x) / length : glm::dvec2(0.0, -1.0);
}

void store(const BoundaryTree& tree, const NearestPacket& packet, int i, int j,
           BoundaryDistances& distances) {
    PacketAnswer answer;
    for (int k = 0; k < kLanes; ++k) {
        const auto lane = static_cast<std::size_t>(k);
        const BoundarySegment& segment = tree.segments[static_cast<std::size_t>(packet.segment[k])];
        answer.toX[lane] = i + k % kSide + 0.5 - segment.start.x;
        answer.toY[lane] = j + k / kSide + 0.5 - segment.start.y;
        answer.alongX[lane] = segment.end.x - segment.start.x;
        answer.alongY[lane] = segment.end.y - segment.start.y;
    }
    RELIEVO_CALL_KERNEL(measurePlaces, answer);
    for (int row = j; row < std::min(j + kSide, distances.distance.height); ++row)
        for (int column = i; column < std::min(i + kSide, distances.distance.width); ++column) {
            const auto lane = static_cast<std::size_t>((row - j) * kSide + column - i);
            const std::size_t texel = distances.distance.index(column, row);
            distances.distance.texels[texel] = static_cast<float>(answer.distance[lane]);
            glm::dvec2 away(answer.awayX[lane], answer.awayY[lane]);
            if (answer.distance[lane] == 0.0)
                away = normalOf(tree.segments[static_cast<std::size_t>(
                    packet.segment[static_cast<int>(lane)])]);
            distances.awayX.texels[texel] = static_cast<float>(away.x);
            distances.awayY.texels[texel] = static_cast<float>(away.y);
        }
}

// A search of a packet that begins with some segments, as good as any where their number is −1.
NearestPacket searched(const BoundaryTree& tree, const StartNodes& starts, int i, int j,
                       std::initializer_list<std::int32_t> seeds) {
    NearestPacket packet = packetAt(i, j);
    std::int32_t last = -1;
    for (const std::int32_t seed : seeds)
        if (seed >= 0 && seed != last) {
            RELIEVO_CALL_KERNEL(tryNearest, tree.segments[static_cast<std::size_t>(seed)], seed,
                                packet);
            last = seed;
        }
    RELIEVO_CALL_KERNEL(findNearestSegments, tree, starts, packet);
    return packet;
}

// Squared distance between a square with its first corner at (left, top) and a box.
float squareToBox(float left, float top, float side, const BoundaryTree::Node& node) {
    const float dx = std::max({node.left - (left + side), left - node.right, 0.0f});
    const float dy = std::max({node.top - (top + side), top - node.bottom, 0.0f});
    return dx * dx + dy * dy;
}

float squareToPlace(float x, float y, const BoundaryTree::Node& node) {
    return squareToBox(x, y, 0.0f, node);
}

// A stack is emptied from its end: the nearest is looked at first.
template <typename IsFarther>
StartNodes nearestLast(StartNodes starts, const IsFarther& isFarther) {
    std::stable_sort(starts.nodes.begin(), starts.nodes.begin() + starts.count, isFarther);
    return starts;
}

// The nodes that a place of the block may have its nearest segment below, of one level of the tree
// as far down as there is room for.
StartNodes startsOf(const BoundaryTree& tree, int i, int j, const NearestPacket& middle) {
    float square = 0.0f;
    for (int k = 0; k < kLanes; ++k)
        square = std::max(square, middle.square[k]);
    // Nothing in the block is further from the places of the packet in its middle than this.
    const float reach = 1.001f * (std::sqrt(square) + 0.7072f * kBlock) + 0.01f;
    const auto left = static_cast<float>(i);
    const auto top = static_cast<float>(j);
    const auto isNear = [&](std::uint32_t node) {
        return squareToBox(left, top, kBlock, tree.nodes[node]) <= reach * reach;
    };
    const auto isFarther = [&](std::uint32_t a, std::uint32_t b) {
        const float half = 0.5f * kBlock;
        return squareToPlace(left + half, top + half, tree.nodes[a]) >
               squareToPlace(left + half, top + half, tree.nodes[b]);
    };
    StartNodes starts;
    for (bool goesOn = true; goesOn;) {
        StartNodes below;
        below.count = 0;
        goesOn = false;
        for (int k = 0; k < starts.count; ++k) {
            const std::uint32_t number = starts.nodes[static_cast<std::size_t>(k)];
            const BoundaryTree::Node& node = tree.nodes[number];
            const bool isLeaf = node.count > 0;
            goesOn = goesOn || !isLeaf;
            for (const std::uint32_t next : {isLeaf ? number : node.first, number + 1})
                if ((!isLeaf || next == number) && isNear(next)) {
                    if (below.count == StartNodes::kMost)
                        return nearestLast(starts, isFarther);
                    below.nodes[static_cast<std::size_t>(below.count++)] = next;
                }
        }
        starts = below;
    }
    return nearestLast(starts, isFarther);
}

// A row of blocks, in rows of packets: memory is filled from its start to its end.
void measureBand(const BoundaryTree& tree, int top, BoundaryDistances& distances) {
    constexpr int kMiddle = (kBlock - kSide) / 2;
    const int width = distances.distance.width;
    const int bottom = std::min(top + kBlock, distances.distance.height);
    std::vector<StartNodes> starts;
    std::int32_t seed = -1;
    for (int i = 0; i < width; i += kBlock) {
        const NearestPacket middle = searched(tree, {}, i + kMiddle, top + kMiddle, {seed});
        seed = middle.segment[0];
        starts.push_back(startsOf(tree, i, top, middle));
    }
    // What was nearest to the last place of each packet of the row before.
    std::vector<std::int32_t> above(static_cast<std::size_t>((width + kSide - 1) / kSide), -1);
    for (int j = top; j < bottom; j += kSide)
        for (int i = 0; i < width; i += kSide) {
            std::int32_t& seedAbove = above[static_cast<std::size_t>(i / kSide)];
            const StartNodes& from = starts[static_cast<std::size_t>(i / kBlock)];
            const NearestPacket packet = searched(tree, from, i, j, {seed, seedAbove});
            seed = packet.segment[kLanes - kSide / 2];
            seedAbove = packet.segment[kLanes - 1];
            store(tree, packet, i, j, distances);
        }
}

}  // namespace

BoundaryDistances measureBoundaryDistances(const BoundaryTree& tree, int width, int height,
                                           const std::function<void(std::size_t)>& advance) {
    using textures::Plane;
    BoundaryDistances distances{Plane(width, height, std::numeric_limits<float>::infinity()),
                                Plane(width, height), Plane(width, height)};
    if (tree.nodes.empty())
        return distances;
    tbb::parallel_for(0, (height + kBlock - 1) / kBlock, [&](int band) {
        measureBand(tree, band * kBlock, distances);
        const int rows = std::min(kBlock, height - band * kBlock);
        if (advance)
            advance(static_cast<std::size_t>(rows) * static_cast<std::size_t>(width));
    });
    return distances;
}

}  // namespace relievo::preprocess
