#include "preprocess/boundary_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "preprocess/lanes.h"
#include "preprocess/processor.h"

namespace relievo::preprocess {
namespace {

constexpr int kSide = 4;  // texels of a packet
static_assert(kSide * kSide == kLanes);

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

void measureRow(const BoundaryTree& tree, int j, BoundaryDistances& distances) {
    std::int32_t seed = -1;
    for (int i = 0; i < distances.distance.width; i += kSide) {
        NearestPacket packet = packetAt(i, j);
        if (seed >= 0)
            RELIEVO_CALL_KERNEL(tryNearest, tree.segments[static_cast<std::size_t>(seed)], seed,
                                packet);
        RELIEVO_CALL_KERNEL(findNearestSegments, tree, packet);
        seed = packet.segment[kLanes - 1];
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
    tbb::parallel_for(0, (height + kSide - 1) / kSide, [&](int row) {
        measureRow(tree, row * kSide, distances);
        const int rows = std::min(kSide, height - row * kSide);
        if (advance)
            advance(static_cast<std::size_t>(rows) * static_cast<std::size_t>(width));
    });
    return distances;
}

}  // namespace relievo::preprocess
