// The nearest segments of squares of places: boundary_distance.cpp. Compiled once for each
// generation of processors (for_each_processor.h).
#include "preprocess/lane_operations.h"

// Sixteen segments of a list as a place sees them.
struct SeenSegments {
    Lanes x;  // from the nearest point of each to the place
    Lanes y;
    Lanes square;  // of the distance
};

inline SeenSegments seeSegments(const SegmentRows& rows, std::size_t first, float x, float y) {
    const Lanes alongX = loadLanes(rows.alongX + first);
    const Lanes alongY = loadLanes(rows.alongY + first);
    const Lanes toX = splat(x) - loadLanes(rows.startX + first);
    const Lanes toY = splat(y) - loadLanes(rows.startY + first);
    const Lanes dot = toX * alongX + toY * alongY;
    const Lanes share =
        larger(smaller(dot * loadLanes(rows.inverseSquare + first), splat(1.0f)), splat(0.0f));
    const Lanes dx = toX - share * alongX;
    const Lanes dy = toY - share * alongY;
    return {dx, dy, dx * dx + dy * dy};
}

// How a place sees the nearest of a list.
inline Sight nearestSight(const SegmentRows& rows, std::size_t count, float x, float y) {
    SeenSegments nearest = seeSegments(rows, 0, x, y);
    for (std::size_t first = kLanes; first < count; first += kLanes) {
        const SeenSegments seen = seeSegments(rows, first, x, y);
        const LaneMask isNearer = seen.square < nearest.square;
        nearest.x = isNearer ? seen.x : nearest.x;
        nearest.y = isNearer ? seen.y : nearest.y;
        nearest.square = isNearer ? seen.square : nearest.square;
    }
    const int lane = firstLane(nearest.square == splat(smallestLane(nearest.square)));
    return Sight(nearest.x[lane], nearest.y[lane]);
}

inline void copyKept(const float* from, LaneMask isKept, float* to) {
    storeLanes(compressLanes(loadLanes(from), isKept), to);
}

// Copies to `kept` what of a list may be the nearest to some place within `radius` of (x,y).
inline void keepNearest(const SegmentList& list, float x, float y, float radius,
                        SegmentList& kept) {
    const SegmentRows from = list.rows;
    const SegmentRows to = kept.rows;
    const Sight nearest = nearestSight(from, list.count, x, y);
    const Margin margin(nearest, radius);
    std::size_t count = 0;
    for (std::size_t first = 0; first < list.count; first += kLanes) {
        const SeenSegments seen = seeSegments(from, first, x, y);
        const Lanes distance = squareRoots(seen.square);
        const Lanes inverse = 1.0f / distance;
        const Lanes turnX = seen.x * inverse - nearest.x;
        const Lanes turnY = seen.y * inverse - nearest.y;
        const Lanes farther = distance - nearest.distance;
        const Lanes beyond = farther - margin.bend;
        const Lanes turned = (turnX * turnX + turnY * turnY) * (radius * radius);
        const LaneMask isKept =
            (farther <= margin.most) & ((beyond <= 0.0f) | ~(beyond * beyond > turned));
        copyKept(from.startX + first, isKept, to.startX + count);
        copyKept(from.startY + first, isKept, to.startY + count);
        copyKept(from.alongX + first, isKept, to.alongX + count);
        copyKept(from.alongY + first, isKept, to.alongY + count);
        copyKept(from.inverseSquare + first, isKept, to.inverseSquare + count);
        storeMask(compressMask(loadMask(from.number + first), isKept), to.number + count);
        count += countLanes(isKept);
    }
    kept.end(count);
}

// The number of the nearest of a list for each place of a square whose first corner is at
// (left, top), row by row. Starts are taken from there, as near as may be: that is where floats are
// exact.
inline void findNearest(const BoundaryTree& tree, const SegmentList& list, double left, double top,
                        std::int32_t* numbers) {
    constexpr int kPackets = kSquarePlaces / kLanes;
    constexpr int kRows = kLanes / kSquare;
    Lanes x;
    Lanes y[kPackets];
    Lanes squares[kPackets];
    LaneMask nearest[kPackets];
    for (int k = 0; k < kLanes; ++k)
        x[k] = static_cast<float>(k % kSquare) + 0.5f;
    for (int p = 0; p < kPackets; ++p) {
        for (int k = 0; k < kLanes; ++k)
            y[p][k] = static_cast<float>(p * kRows + k / kSquare) + 0.5f;
        squares[p] = splat(std::numeric_limits<float>::infinity());
        nearest[p] = LaneMask{};
    }
    const SegmentRows rows = list.rows;
    for (std::size_t k = 0; k < list.count; ++k) {
        const glm::dvec2& start = tree.segments[static_cast<std::size_t>(rows.number[k])].start;
        const Lanes alongX = splat(rows.alongX[k]);
        const Lanes alongY = splat(rows.alongY[k]);
        const Lanes inverse = splat(rows.inverseSquare[k]);
        const Lanes toX = x - static_cast<float>(start.x - left);
        const Lanes dotX = toX * alongX;
        const Lanes startY = splat(static_cast<float>(start.y - top));
        for (int p = 0; p < kPackets; ++p) {
            const Lanes toY = y[p] - startY;
            const Lanes share =
                larger(smaller((dotX + toY * alongY) * inverse, splat(1.0f)), splat(0.0f));
            const Lanes dx = toX - share * alongX;
            const Lanes dy = toY - share * alongY;
            const Lanes square = dx * dx + dy * dy;
            const LaneMask isNearer = square < squares[p];
            squares[p] = isNearer ? square : squares[p];
            nearest[p] = isNearer ? LaneMask{} + rows.number[k] : nearest[p];
        }
    }
    for (int p = 0; p < kPackets; ++p)
        storeMask(nearest[p], numbers + p * kLanes);
}

// Distances and directions from the segments with these numbers, in double precision.
inline void measurePlaces(const BoundaryTree& tree, double left, double top,
                          const std::int32_t* numbers, MeasuredSquare& measured) {
    double startX[kSquarePlaces];
    double startY[kSquarePlaces];
    double endX[kSquarePlaces];
    double endY[kSquarePlaces];
    for (int k = 0; k < kSquarePlaces; ++k) {
        const BoundarySegment& segment = tree.segments[static_cast<std::size_t>(numbers[k])];
        startX[k] = segment.start.x;
        startY[k] = segment.start.y;
        endX[k] = segment.end.x;
        endY[k] = segment.end.y;
    }
    for (int k = 0; k < kSquarePlaces; ++k) {
        const double toX = left + (k % kSquare + 0.5) - startX[k];
        const double toY = top + (k / kSquare + 0.5) - startY[k];
        const double alongX = endX[k] - startX[k];
        const double alongY = endY[k] - startY[k];
        const double square = alongX * alongX + alongY * alongY;
        const double dot = toX * alongX + toY * alongY;
        const double share = dot <= 0.0 ? 0.0 : (dot >= square ? 1.0 : dot / square);
        const double x = toX - share * alongX;
        const double y = toY - share * alongY;
        const double distance = std::sqrt(x * x + y * y);
        const double inverse = distance > 0.0 ? 1.0 / distance : 0.0;
        measured.distance[k] = static_cast<float>(distance);
        measured.awayX[k] = static_cast<float>(x * inverse);
        measured.awayY[k] = static_cast<float>(y * inverse);
    }
}
