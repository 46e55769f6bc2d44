#include "preprocess/distance_transform.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace relievo::preprocess {
namespace {

using textures::WrapMode;
constexpr std::int64_t kUnlimited = SquaredDistances::kUnlimited;

// The places of an axis that can be nearest to one of its texels: with repeat half a period on
// either side as well, because no nearest copy is farther.
struct AxisRange {
    int first;
    int end;
};

AxisRange rangeOf(int size, WrapMode wrap) {
    const int margin = wrap == WrapMode::Repeat ? size / 2 : 0;
    return {-margin, size + margin};
}

std::size_t wrapped(int place, int size) {
    return static_cast<std::size_t>(textures::wrapIndex(place, size, WrapMode::Repeat));
}

// Squared distances to the set along column i: one sweep down and one up.
void measureColumn(int i, WrapMode wrap, const std::vector<std::uint8_t>& set,
                   SquaredDistances& distances) {
    const AxisRange rows = rangeOf(distances.height, wrap);
    const auto indexOf = [&](int row) {
        return wrapped(row, distances.height) * static_cast<std::size_t>(distances.width) +
               static_cast<std::size_t>(i);
    };
    const auto sweep = [&](int start, int end, int step) {
        std::int64_t sinceSet = kUnlimited;
        for (int row = start; row != end; row += step) {
            const std::size_t texel = indexOf(row);
            if (set[texel] != 0)
                sinceSet = 0;
            else if (sinceSet != kUnlimited)
                ++sinceSet;
            if (sinceSet != kUnlimited && row >= 0 && row < distances.height)
                distances.texels[texel] = std::min(distances.texels[texel], sinceSet * sinceSet);
        }
    };
    sweep(rows.first, rows.end, 1);
    sweep(rows.end - 1, rows.first - 1, -1);
}

// A parabola of the lower envelope: (x − place)² + offset, the lowest from x = start on.
struct Parabola {
    std::int64_t place;
    std::int64_t offset;
    std::int64_t start;
};

std::int64_t floorDivide(std::int64_t a, std::int64_t b) {
    assert(b > 0);
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// The first whole x at which parabola `b`, to the right of `a`, is lower than `a`.
std::int64_t overtaking(const Parabola& a, const Parabola& b) {
    const std::int64_t difference = b.place * b.place + b.offset - a.place * a.place - a.offset;
    return floorDivide(difference, 2 * (b.place - a.place)) + 1;
}

// Row j: from distances along columns to distances in the plane. `envelope` and `columnDistances`
// are scratch space.
void measureRow(int j, WrapMode wrap, SquaredDistances& distances, std::vector<Parabola>& envelope,
                std::vector<std::int64_t>& columnDistances) {
    const AxisRange columns = rangeOf(distances.width, wrap);
    const auto row = distances.texels.begin() +
                     static_cast<std::ptrdiff_t>(j) * static_cast<std::ptrdiff_t>(distances.width);
    columnDistances.assign(row, row + distances.width);
    envelope.clear();
    for (int place = columns.first; place < columns.end; ++place) {
        Parabola next{place, columnDistances[wrapped(place, distances.width)], columns.first};
        if (next.offset == kUnlimited)
            continue;
        while (!envelope.empty()) {
            next.start = overtaking(envelope.back(), next);
            if (next.start > envelope.back().start)
                break;
            envelope.pop_back();
            next.start = columns.first;
        }
        envelope.push_back(next);
    }
    if (envelope.empty())
        return;
    auto lowest = envelope.begin();
    for (int x = 0; x < distances.width; ++x) {
        while (lowest + 1 != envelope.end() && (lowest + 1)->start <= x)
            ++lowest;
        row[x] = (x - lowest->place) * (x - lowest->place) + lowest->offset;
    }
}

}  // namespace

SquaredDistances distancesTo(const std::vector<std::uint8_t>& set, int width, int height,
                             WrapMode wrap) {
    assert(set.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    SquaredDistances distances{width, height, {}};
    distances.texels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                            kUnlimited);
    tbb::parallel_for(tbb::blocked_range<int>(0, width), [&](const tbb::blocked_range<int>& range) {
        for (int i = range.begin(); i < range.end(); ++i)
            measureColumn(i, wrap, set, distances);
    });
    tbb::parallel_for(tbb::blocked_range<int>(0, height),
                      [&](const tbb::blocked_range<int>& range) {
                          std::vector<Parabola> envelope;
                          std::vector<std::int64_t> columnDistances;
                          for (int j = range.begin(); j < range.end(); ++j)
                              measureRow(j, wrap, distances, envelope, columnDistances);
                      });
    return distances;
}

}  // namespace relievo::preprocess
