#include "textures/halved_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "random_planes.h"

namespace relievo::textures {
namespace {

// The integral of the samples, as constants over their texels, over a rectangle in [0,1]².
double integral(const Plane& plane, double left, double top, double right, double bottom) {
    double sum = 0.0;
    for (int j = 0; j < plane.height; ++j)
        for (int i = 0; i < plane.width; ++i) {
            const double w = std::min(right, (i + 1.0) / plane.width) -
                             std::max(left, static_cast<double>(i) / plane.width);
            const double h = std::min(bottom, (j + 1.0) / plane.height) -
                             std::max(top, static_cast<double>(j) / plane.height);
            sum += plane.at(i, j) * std::max(w, 0.0) * std::max(h, 0.0);
        }
    return sum;
}

TEST(HalvedPlane, SamplesAreMeansOverTheirArea) {
    for (const auto& [width, height] : {std::array{8, 6}, std::array{7, 5}, std::array{13, 1},
                                        std::array{1, 2}, std::array{3, 64}, std::array{1, 1}}) {
        const Plane fine = randomPlane(width, height, 0.0f, 1.0f, 7);
        const Plane coarse = halvedByArea(fine);
        ASSERT_EQ(coarse.width, std::max(width / 2, 1));
        ASSERT_EQ(coarse.height, std::max(height / 2, 1));
        for (int j = 0; j < coarse.height; ++j)
            for (int i = 0; i < coarse.width; ++i) {
                const double mean = integral(fine, 1.0 * i / coarse.width, 1.0 * j / coarse.height,
                                             (i + 1.0) / coarse.width, (j + 1.0) / coarse.height) *
                                    coarse.width * coarse.height;
                EXPECT_NEAR(coarse.at(i, j), mean, 1e-6) << width << "×" << height;
            }
    }
    // The wrong variant, means of 2×2 that leave out the last column, must not pass for it.
    const Plane fine = randomPlane(7, 1, 0.0f, 1.0f, 7);
    EXPECT_GT(std::abs(0.5 * (fine.at(4, 0) + fine.at(5, 0)) -
                       3.0 * integral(fine, 2.0 / 3, 0.0, 1.0, 1.0)),
              0.01);
}

}  // namespace
}  // namespace relievo::textures
