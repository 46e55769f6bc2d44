#include "preprocess/displacement_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

namespace relievo::preprocess {
namespace {

using textures::Plane;

// How often each error comes, by the bits of a float that tell numbers 1 % apart.
class ErrorCounts {
  public:
    ErrorCounts()
        : counts_(std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity()) >>
                  kDropped) {}

    void add(double value) {
        ++counts_[std::bit_cast<std::uint32_t>(static_cast<float>(value)) >> kDropped];
        sum_ += value;
        ++count_;
        greatest_ = std::max(greatest_, value);
    }
    void add(const ErrorCounts& other) {
        std::transform(counts_.begin(), counts_.end(), other.counts_.begin(), counts_.begin(),
                       std::plus<>());
        sum_ += other.sum_;
        count_ += other.count_;
        greatest_ = std::max(greatest_, other.greatest_);
    }
    [[nodiscard]] DisplacementError result() const {
        if (count_ == 0)
            return {};
        std::size_t below = 0;
        std::uint32_t bin = 0;
        while (100 * (below += counts_[bin]) < 99 * count_)
            ++bin;
        const double end = std::bit_cast<float>((bin + 1) << kDropped);
        return {sum_ / static_cast<double>(count_), std::min(end, greatest_), greatest_};
    }

  private:
    static constexpr int kDropped = 16;  // of the bits of a float: 7 of its fraction are left
    std::vector<std::size_t> counts_;
    double sum_ = 0.0;
    std::size_t count_ = 0;
    double greatest_ = 0.0;
};

// Counts the errors of one view, whose hits are those with at most as many `misses`.
void countErrors(const Plane& truth, const ViewGrid& grid, const DisplacementFactors& factors,
                 std::size_t view, int elevation, const Plane* misses, ErrorCounts& errors) {
    for (std::size_t texel = 0; texel < truth.texels.size(); ++texel)
        if (misses == nullptr || static_cast<float>(elevation) >= misses->texels[texel])
            errors.add(std::abs(displacementOf(factors, grid, view, texel) -
                                static_cast<double>(truth.texels[texel])));
}

// Counts those of the views of one curvature.
ErrorCounts errorsOf(const std::vector<Plane>& table, const ViewGrid& grid,
                     const DisplacementFactors& factors, int curvature) {
    ErrorCounts errors;
    for (int elevation = 0; elevation < grid.elevations; ++elevation)
        for (int azimuth = 0; azimuth < grid.azimuths; ++azimuth) {
            const std::size_t view = grid.view(azimuth, elevation, curvature);
            const Plane* const misses = curvature > grid.curvatures / 2
                                            ? &factors.misses[missesPlane(grid, azimuth, curvature)]
                                            : nullptr;
            countErrors(table[view], grid, factors, view, elevation, misses, errors);
        }
    return errors;
}

}  // namespace

DisplacementError measureFactors(const std::vector<Plane>& table, const ViewGrid& grid,
                                 const DisplacementFactors& factors) {
    // Each curvature has sums of its own, which are added in order: the same for any number of
    // threads.
    std::vector<ErrorCounts> parts(static_cast<std::size_t>(grid.curvatures));
    tbb::parallel_for(0, grid.curvatures, [&](int curvature) {
        parts[static_cast<std::size_t>(curvature)] = errorsOf(table, grid, factors, curvature);
    });
    ErrorCounts errors;
    for (const ErrorCounts& part : parts)
        errors.add(part);
    return errors.result();
}

}  // namespace relievo::preprocess
