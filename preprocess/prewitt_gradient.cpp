#include "preprocess/prewitt_gradient.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace relievo::preprocess {
namespace {

using textures::Plane;

constexpr int kRowsAtOnce = 32;

// One row with the columns that a kernel of radius r reaches beyond its ends.
class PaddedRow {
  public:
    PaddedRow(int width, int radius, textures::WrapMode wrap)
        : width_(width),
          radius_(radius),
          wrap_(wrap),
          values_(static_cast<std::size_t>(width + 2 * radius)) {}

    // Fills the row from what is in its middle.
    void pad() {
        float* const middle = values_.data() + radius_;
        for (int k = 1; k <= radius_; ++k) {
            middle[-k] = middle[textures::wrapIndex(-k, width_, wrap_)];
            middle[width_ - 1 + k] = middle[textures::wrapIndex(width_ - 1 + k, width_, wrap_)];
        }
    }
    [[nodiscard]] float* middle() { return values_.data() + radius_; }

  private:
    int width_;
    int radius_;
    textures::WrapMode wrap_;
    std::vector<float> values_;
};

}  // namespace

void prewittGradient(const Plane& values, textures::WrapMode wrap, int size, Plane& gradientX,
                     Plane& gradientY) {
    assert(size % 2 == 1 && size >= 3 && size <= kLargestPrewitt);
    const int width = values.width;
    const int radius = size / 2;
    gradientX = Plane(width, values.height);
    gradientY = Plane(width, values.height);
    // Differences of opposite texels first: where all are equal the slope is exactly 0.
    const auto work = [&](const tbb::blocked_range<int>& rows) {
        PaddedRow sum(width, radius, wrap);   // of the kernel's rows
        PaddedRow ramp(width, radius, wrap);  // weighted by their number
        for (int j = rows.begin(); j < rows.end(); ++j) {
            std::fill_n(ramp.middle(), width, 0.0f);
            const auto row = [&](int number) {
                return &values.texels[values.index(
                    0, textures::wrapIndex(number, values.height, wrap))];
            };
            std::copy_n(row(j), width, sum.middle());
            for (int k = 1; k <= radius; ++k) {
                const float* const above = row(j - k);
                const float* const below = row(j + k);
                for (int i = 0; i < width; ++i) {
                    sum.middle()[i] += above[i] + below[i];
                    ramp.middle()[i] += static_cast<float>(k) * (below[i] - above[i]);
                }
            }
            sum.pad();
            ramp.pad();
            float* const x = &gradientX.texels[gradientX.index(0, j)];
            float* const y = &gradientY.texels[gradientY.index(0, j)];
            std::copy_n(ramp.middle(), width, y);
            for (int k = 1; k <= radius; ++k)
                for (int i = 0; i < width; ++i) {
                    x[i] += static_cast<float>(k) * (sum.middle()[i + k] - sum.middle()[i - k]);
                    y[i] += ramp.middle()[i + k] + ramp.middle()[i - k];
                }
            for (int i = 0; i < width; ++i) {
                const float length = std::sqrt(x[i] * x[i] + y[i] * y[i]);
                const float scale = length > 0.0f ? 1.0f / length : 0.0f;
                x[i] *= scale;
                y[i] *= scale;
            }
        }
    };
    tbb::parallel_for(tbb::blocked_range<int>(0, values.height, kRowsAtOnce), work);
}

}  // namespace relievo::preprocess
