#include "preprocess/distance_transform.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "textures/input_error.h"

namespace relievo::preprocess {
namespace {

using textures::WrapMode;

// Columns are measured in stripes as wide as a cache line of the set: memory is read in rows, and
// what a stripe needs between its two passes is small and in one piece.
constexpr int kStripe = 64;
template <typename T>
using Stripe = std::array<T, kStripe>;

// Distances along columns take 16 bits; this one stands for none and stays what it is when rows are
// added. Its square is above that of the diagonal, so that a column without a texel of the set
// loses to every other one without being told apart.
using RowCount = std::uint16_t;
constexpr RowCount kNone = UINT16_MAX;

void refuseLargeMaps(int width, int height) {
    const std::int64_t squaredDiagonal =
        static_cast<std::int64_t>(width) * width + static_cast<std::int64_t>(height) * height;
    if (squaredDiagonal >= static_cast<std::int64_t>(kNone) * kNone)
        throw textures::InputError("a map of " + std::to_string(width) + "x" +
                                   std::to_string(height) +
                                   " texels is too large for a distance transform: the diagonal "
                                   "must be under 65535 texels");
}

RowCount oneMore(RowCount rows) {
    return static_cast<RowCount>(rows + (rows != kNone ? 1 : 0));
}

// `count` columns of the map from `first` on, from which distances go to `squared`.
struct Columns {
    const std::uint8_t* set;  // of the first of these columns in row 0
    std::uint32_t* squared;   // likewise
    int count;
    int height;
    std::size_t pitch;  // of both, in texels
};

// How many rows each column must be followed to its first texel of the set, from the top down or
// from the bottom up; kNone where there is none.
Stripe<RowCount> rowsToSet(const Columns& columns, bool fromTop) {
    Stripe<RowCount> rows;
    rows.fill(kNone);
    int missing = columns.count;
    for (int k = 0; k < columns.height && missing > 0; ++k) {
        const int j = fromTop ? k : columns.height - 1 - k;
        const std::uint8_t* const set = columns.set + static_cast<std::size_t>(j) * columns.pitch;
        missing = 0;
        for (int i = 0; i < columns.count; ++i) {
            const RowCount here = set[i] != 0 ? static_cast<RowCount>(k) : kNone;
            rows[i] = std::min(rows[i], here);
            missing += rows[i] == kNone ? 1 : 0;
        }
    }
    return rows;
}

// Squared distances along the columns of a stripe: one pass down and one up. With repeat each
// starts from what the copy before the first row would hand over. Whether a column has any texel of
// the set.
bool measureColumns(const Columns& columns, WrapMode wrap, std::vector<Stripe<RowCount>>& scratch) {
    Stripe<RowCount> above;
    Stripe<RowCount> below;
    above.fill(kNone);
    below.fill(kNone);
    if (wrap == WrapMode::Repeat) {
        above = rowsToSet(columns, false);
        below = rowsToSet(columns, true);
    }
    scratch.resize(static_cast<std::size_t>(columns.height));
    for (int j = 0; j < columns.height; ++j) {
        const std::uint8_t* const set = columns.set + static_cast<std::size_t>(j) * columns.pitch;
        for (int i = 0; i < columns.count; ++i)
            above[i] = set[i] != 0 ? RowCount{0} : oneMore(above[i]);
        scratch[static_cast<std::size_t>(j)] = above;
    }
    for (int j = columns.height - 1; j >= 0; --j) {
        std::uint32_t* const squared =
            columns.squared + static_cast<std::size_t>(j) * columns.pitch;
        const Stripe<RowCount>& nearestAbove = scratch[static_cast<std::size_t>(j)];
        for (int i = 0; i < columns.count; ++i) {
            below[i] = std::min(nearestAbove[i], oneMore(below[i]));
            squared[i] = static_cast<std::uint32_t>(below[i]) * below[i];
        }
    }
    return std::any_of(below.begin(), below.begin() + columns.count,
                       [](RowCount rows) { return rows != kNone; });
}

// A parabola of the lower envelope: (x − place)² + offset = x² − 2·place·x + key, the lowest from
// x = start on.
struct Parabola {
    double key;  // place² + offset, a whole number
    std::int32_t place;
    std::int32_t start;
    std::uint32_t offset;
};

// 1/(2k) for k = 0 … last; anything for k = 0.
std::vector<double> halfReciprocals(std::size_t last) {
    std::vector<double> reciprocals{0.0};
    for (std::size_t k = 1; k <= last; ++k)
        reciprocals.push_back(0.5 / static_cast<double>(k));
    return reciprocals;
}

// Behind the end of every row.
constexpr double kFar = 1 << 30;

// Scratch memory for rows of one size.
class RowMeasure {
  public:
    // `reciprocals`: those of halfReciprocals, up to the width.
    RowMeasure(std::size_t width, WrapMode wrap, const std::vector<double>& reciprocals)
        : repeats_(wrap == WrapMode::Repeat),
          offsets_(width + (repeats_ ? 1 : 0)),
          distances_(offsets_.size()),
          envelope_(offsets_.size() + 1),
          reciprocals_(reciprocals) {}

    // From distances along columns to distances in the plane.
    //
    // A parabola with the least offset of the row is a watershed: what lies on one of its sides is
    // never lower than it on the other. So the row is measured from one least place to the next;
    // where the set is dense that is a few texels at a time. With repeat the row is turned until it
    // begins with a least place, and ends with its copy: nothing else repeats.
    void measure(std::span<std::uint32_t> row) {
        std::uint32_t least = SquaredDistances::kUnlimited;
        for (const std::uint32_t offset : row)
            least = std::min(least, offset);
        const auto first = repeats_ ? std::find(row.begin(), row.end(), least) : row.begin();
        std::rotate_copy(row.begin(), first, row.end(), offsets_.begin());
        if (repeats_)
            offsets_.back() = least;
        measureBetween(least);
        std::rotate_copy(distances_.begin(), distances_.begin() + (row.end() - first),
                         distances_.begin() + static_cast<std::ptrdiff_t>(row.size()), row.begin());
    }

  private:
    void measureBetween(std::uint32_t least) {
        const int last = static_cast<int>(offsets_.size()) - 1;
        distances_[0] = offsets_[0];
        int begin = 0;
        for (int x = 1; x <= last; ++x) {
            if (offsets_[static_cast<std::size_t>(x)] != least && x != last)
                continue;
            if (x == begin + 1 && offsets_[static_cast<std::size_t>(begin)] == least &&
                offsets_[static_cast<std::size_t>(x)] == least)
                distances_[static_cast<std::size_t>(x)] = least;
            else
                measureSpan(begin, x);
            begin = x;
        }
    }

    // The first whole x at which `b`, to the right of `a`, is lower than `a`; 0 or less for any
    // that is not positive. The product stands for a division of integers: the half added to the
    // numerator keeps the quotient at least 1/4·(b.place − a.place)⁻¹ away from whole numbers, far
    // more than rounding moves it.
    [[nodiscard]] std::int32_t overtaking(const Parabola& a, const Parabola& b) const {
        const double x =
            (b.key - a.key + 0.5) * reciprocals_[static_cast<std::size_t>(b.place - a.place)];
        return static_cast<std::int32_t>(std::min(x + 1.0, kFar));
    }

    // The lower envelope of the parabolas from `begin` to `last`, and the distances there.
    void measureSpan(int begin, int last) {
        const int length = last - begin;
        const std::uint32_t* const offsets = offsets_.data() + begin;
        Parabola* const envelope = envelope_.data();
        int count = 0;
        for (int place = 0; place <= length; ++place) {
            const double squared = static_cast<double>(place) * place;
            Parabola next{squared + offsets[place], place, 0, offsets[place]};
            for (; count > 0; --count) {
                next.start = overtaking(envelope[count - 1], next);
                if (next.start > envelope[count - 1].start)
                    break;
            }
            next.start = count > 0 ? next.start : 0;
            if (next.start <= length)
                envelope[count++] = next;
        }
        envelope[count].start = length + 1;
        // Starts are whole and ascend, so that one step at a time keeps up.
        const Parabola* lowest = envelope;
        std::uint32_t* const distances = distances_.data() + begin;
        for (int x = 0; x <= length; ++x) {
            lowest += lowest[1].start <= x ? 1 : 0;
            const auto across = static_cast<std::uint32_t>(std::abs(x - lowest->place));
            distances[x] = across * across + lowest->offset;
        }
    }

    bool repeats_;
    std::vector<std::uint32_t> offsets_;
    std::vector<std::uint32_t> distances_;
    std::vector<Parabola> envelope_;
    const std::vector<double>& reciprocals_;
};

}  // namespace

void measureDistances(std::span<const std::uint8_t> set, int width, int height, WrapMode wrap,
                      SquaredDistances& distances) {
    const std::size_t pitch = static_cast<std::size_t>(width);
    assert(set.size() == pitch * static_cast<std::size_t>(height));
    refuseLargeMaps(width, height);
    distances.width = width;
    distances.height = height;
    distances.texels.resize(set.size());
    std::atomic<bool> empty{true};
    tbb::parallel_for(tbb::blocked_range<int>(0, (width + kStripe - 1) / kStripe),
                      [&](const tbb::blocked_range<int>& stripes) {
                          std::vector<Stripe<RowCount>> scratch;
                          for (int k = stripes.begin(); k < stripes.end(); ++k) {
                              const int first = k * kStripe;
                              const Columns columns{
                                  set.data() + first, distances.texels.data() + first,
                                  std::min(kStripe, width - first), height, pitch};
                              if (measureColumns(columns, wrap, scratch))
                                  empty = false;
                          }
                      });
    if (empty) {
        std::fill(distances.texels.begin(), distances.texels.end(), SquaredDistances::kUnlimited);
        return;
    }
    const std::vector<double> reciprocals = halfReciprocals(pitch);
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 16),
                      [&](const tbb::blocked_range<int>& rows) {
                          RowMeasure row(pitch, wrap, reciprocals);
                          for (int j = rows.begin(); j < rows.end(); ++j)
                              row.measure(std::span(distances.texels)
                                              .subspan(static_cast<std::size_t>(j) * pitch, pitch));
                      });
}

SquaredDistances distancesTo(std::span<const std::uint8_t> set, int width, int height,
                             WrapMode wrap) {
    SquaredDistances distances;
    measureDistances(set, width, height, wrap, distances);
    return distances;
}

}  // namespace relievo::preprocess
