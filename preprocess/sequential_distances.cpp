#include "preprocess/sequential_distances.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace relievo::preprocess {
namespace {

// How far the nearest texel of the set that is known so far lies to the side and up or down.
struct Offset {
    std::int32_t across;
    std::int32_t down;

    [[nodiscard]] std::int64_t squared() const {
        return static_cast<std::int64_t>(across) * across + static_cast<std::int64_t>(down) * down;
    }
};

// Above every distance of maps that distancesTo accepts.
constexpr std::int32_t kNone = 1 << 20;

// The places that a sweep along an axis visits: with repeat half a round more, so that every texel
// hears of what lies half a period before it.
int sweepLength(int size, textures::WrapMode wrap) {
    return wrap == textures::WrapMode::Repeat ? size + size / 2 : size;
}

class Sweeps {
  public:
    Sweeps(std::span<const std::uint8_t> set, int width, int height, textures::WrapMode wrap)
        : width_(width),
          height_(height),
          repeats_(wrap == textures::WrapMode::Repeat),
          columns_(sweepLength(width, wrap)),
          rows_(sweepLength(height, wrap)),
          offsets_(set.size(), {kNone, kNone}) {
        for (std::size_t k = 0; k < set.size(); ++k)
            if (set[k] != 0)
                offsets_[k] = {0, 0};
    }

    // All rows in the direction `step`: down (1) or up (-1).
    void sweepRows(int step) {
        for (int k = 0; k < rows_; ++k) {
            const int row = placeOf(k, step, height_);
            const bool hasBefore = repeats_ || k > 0;
            const int before = placeOf(k + height_ - 1, step, height_);
            sweepRow(row, hasBefore ? before : row, step);
            sweepRow(row, row, -step);
        }
    }

    [[nodiscard]] const std::vector<Offset>& offsets() const { return offsets_; }

  private:
    // The k-th place of a sweep over `size` places.
    static int placeOf(int k, int step, int size) {
        return step > 0 ? k % size : size - 1 - k % size;
    }

    void takeOver(Offset& own, const Offset& neighbour, int across, int down) const {
        const Offset offered{neighbour.across + across, neighbour.down + down};
        if (offered.squared() < own.squared())
            own = offered;
    }

    // Row `row` in the direction `step`, from the neighbours behind in the row and those in the row
    // `before`, unless that is the row itself.
    void sweepRow(int row, int before, int step) {
        Offset* const own = offsets_.data() + static_cast<std::size_t>(row) * width_;
        const Offset* const other = offsets_.data() + static_cast<std::size_t>(before) * width_;
        for (int k = 0; k < columns_; ++k) {
            const int i = placeOf(k, step, width_);
            if (repeats_ || k > 0)
                takeOver(own[i], own[placeOf(k + width_ - 1, step, width_)], 1, 0);
            if (before != row)
                takeOver(own[i], other[i], 0, 1);
        }
    }

    int width_;
    int height_;
    bool repeats_;
    int columns_;
    int rows_;
    std::vector<Offset> offsets_;
};

}  // namespace

SquaredDistances sequentialDistances(std::span<const std::uint8_t> set, int width, int height,
                                     textures::WrapMode wrap) {
    assert(set.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    Sweeps sweeps(set, width, height, wrap);
    sweeps.sweepRows(1);
    sweeps.sweepRows(-1);
    SquaredDistances distances{width, height, std::vector<std::uint32_t>(set.size())};
    std::transform(sweeps.offsets().begin(), sweeps.offsets().end(), distances.texels.begin(),
                   [](const Offset& offset) {
                       return offset.across < kNone ? static_cast<std::uint32_t>(offset.squared())
                                                    : SquaredDistances::kUnlimited;
                   });
    return distances;
}

DistanceErrors compareDistances(const SquaredDistances& measured, const SquaredDistances& exact) {
    assert(measured.texels.size() == exact.texels.size());
    DistanceErrors errors;
    for (std::size_t k = 0; k < exact.texels.size(); ++k) {
        const std::uint32_t found = measured.texels[k];
        const std::uint32_t truth = exact.texels[k];
        errors.tooLarge += found > truth ? 1 : 0;
        errors.tooSmall += found < truth ? 1 : 0;
        errors.greatest =
            std::max(errors.greatest, std::abs(std::sqrt(static_cast<double>(found)) -
                                               std::sqrt(static_cast<double>(truth))));
    }
    return errors;
}

}  // namespace relievo::preprocess
