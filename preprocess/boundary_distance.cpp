#include "preprocess/boundary_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
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

glm::dvec2 nearestPoint(const BoundarySegment& segment, const glm::dvec2& place) {
    const glm::dvec2 along = segment.end - segment.start;
    const double square = glm::dot(along, along);
    const double share =
        square > 0.0 ? std::clamp(glm::dot(place - segment.start, along) / square, 0.0, 1.0) : 0.0;
    return segment.start + share * along;
}

glm::dvec2 normalOf(const BoundarySegment& segment) {
    const glm::dvec2 along = segment.end - segment.start;
    const double length = glm::length(along);
    return length > 0.0 ? glm::dvec2(along.y, -along.x) / length : glm::dvec2(0.0, -1.0);
}

void store(const BoundaryTree& tree, const NearestPacket& packet, int i, int j,
           BoundaryDistances& distances) {
    for (int k = 0; k < kLanes; ++k) {
        const int column = i + k % kSide;
        const int row = j + k / kSide;
        if (column >= distances.distance.width || row >= distances.distance.height)
            continue;
        const glm::dvec2 place(column + 0.5, row + 0.5);
        const auto number = static_cast<std::size_t>(packet.segment[k]);
        const glm::dvec2 away = place - nearestPoint(tree.segments[number], place);
        const double distance = glm::length(away);
        distances.distance.at(column, row) = static_cast<float>(distance);
        const glm::dvec2 unit = distance > 0.0 ? away / distance : normalOf(tree.segments[number]);
        distances.awayX.at(column, row) = static_cast<float>(unit.x);
        distances.awayY.at(column, row) = static_cast<float>(unit.y);
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
