// The nearest segments of a packet of places: boundary_distance.cpp. Compiled once for each
// generation of processors (for_each_processor.h).
#include "preprocess/lane_operations.h"

// Squared distances from the places to a box.
inline Lanes squaresToBox(Lanes x, Lanes y, const BoundaryTree::Node& node, float left, float top) {
    const Lanes zero = splat(0.0f);
    const Lanes dx =
        larger(larger(splat(node.left - left) - x, x - splat(node.right - left)), zero);
    const Lanes dy = larger(larger(splat(node.top - top) - y, y - splat(node.bottom - top)), zero);
    return dx * dx + dy * dy;
}

// Takes the segment where it is nearer than what was found.
inline void tryNearest(const BoundarySegment& segment, std::int32_t number, NearestPacket& packet) {
    const auto startX = static_cast<float>(segment.start.x - packet.originX);
    const auto startY = static_cast<float>(segment.start.y - packet.originY);
    const auto alongX = static_cast<float>(segment.end.x - segment.start.x);
    const auto alongY = static_cast<float>(segment.end.y - segment.start.y);
    const float square = alongX * alongX + alongY * alongY;
    const float inverse = square > 0.0f ? 1.0f / square : 0.0f;
    const Lanes toX = packet.x - startX;
    const Lanes toY = packet.y - startY;
    const Lanes share =
        larger(smaller((toX * alongX + toY * alongY) * inverse, splat(1.0f)), splat(0.0f));
    const Lanes dx = toX - share * alongX;
    const Lanes dy = toY - share * alongY;
    const Lanes squares = dx * dx + dy * dy;
    const LaneMask isNearer = squares < packet.square;
    packet.square = isNearer ? squares : packet.square;
    packet.segment = isNearer ? LaneMask{} + number : packet.segment;
}

inline void findNearestSegments(const BoundaryTree& tree, const StartNodes& starts,
                                NearestPacket& packet) {
    const auto left = static_cast<float>(packet.originX);
    const auto top = static_cast<float>(packet.originY);
    // Halving: no deeper than the bits of a number of segments.
    std::uint32_t stack[64 + StartNodes::kMost];
    int size = 0;
    while (size < starts.count) {
        stack[size] = starts.nodes[static_cast<std::size_t>(size)];
        ++size;
    }
    while (size > 0) {
        const std::uint32_t number = stack[--size];
        const BoundaryTree::Node& node = tree.nodes[number];
        if (!anyLane(squaresToBox(packet.x, packet.y, node, left, top) < packet.square))
            continue;
        for (std::uint32_t k = 0; k < node.count; ++k)
            tryNearest(tree.segments[node.first + k], static_cast<std::int32_t>(node.first + k),
                       packet);
        if (node.count > 0)
            continue;
        stack[size++] = node.first;
        stack[size++] = number + 1;
    }
}

inline void measurePlaces(PacketAnswer& answer) {
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double alongX = answer.alongX[k];
        const double alongY = answer.alongY[k];
        const double square = alongX * alongX + alongY * alongY;
        const double dot = answer.toX[k] * alongX + answer.toY[k] * alongY;
        const double share = dot <= 0.0 ? 0.0 : (dot >= square ? 1.0 : dot / square);
        const double x = answer.toX[k] - share * alongX;
        const double y = answer.toY[k] - share * alongY;
        const double distance = std::sqrt(x * x + y * y);
        const double inverse = distance > 0.0 ? 1.0 / distance : 0.0;
        answer.distance[k] = distance;
        answer.awayX[k] = x * inverse;
        answer.awayY[k] = y * inverse;
    }
}
