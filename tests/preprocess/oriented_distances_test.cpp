// Signs and rounding of distances against the same said plainly, texel by texel.
#include "preprocess/oriented_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "preprocess/processor.h"

namespace relievo::preprocess {
namespace {

constexpr std::array kProcessors{Processor::Baseline, Processor::Avx2, Processor::Avx512};
constexpr double kLongest = 64.0;

// Of either sign, small and large, and zeros of both signs.
std::vector<float> someDistances(std::size_t count) {
    std::mt19937 random(4);
    std::normal_distribution<double> exponent(0.0, 3.0);
    std::vector<float> distances(count);
    for (float& distance : distances)
        distance =
            static_cast<float>((random() % 2 == 0 ? 1.0 : -1.0) * std::exp(exponent(random)));
    for (std::size_t k = 0; k < count; k += 13)
        distances[k] = k % 2 == 0 ? 0.0f : -0.0f;
    return distances;
}

TEST(OrientedDistances, SureOnesAreNoFartherAndSlackSaysHowMuchNearer) {
    for (const std::size_t count : {1u, 7u, 8u, 9u, 1000u})
        for (const int width : {1, 61, 2048}) {
            const std::vector<float> measured = someDistances(count);
            std::vector<float> sure = measured;
            const double slack = makeDistancesSure(sure, width, kLongest);
            double most = 0.0;
            for (std::size_t k = 0; k < count; ++k) {
                const double distance = std::abs(static_cast<double>(measured[k]));
                const double off = 0x1p-21 * (distance + kLongest) + 1e-6;
                ASSERT_EQ(std::signbit(sure[k]), std::signbit(measured[k]));
                const double kept = std::abs(static_cast<double>(sure[k])) * width;
                ASSERT_LE(kept, std::max(distance - off, 0.0));
                // The next float would be too large: what is measured is not even nearly enough.
                ASSERT_GT(std::nextafter(std::abs(sure[k]), HUGE_VALF) * static_cast<double>(width),
                          (distance - off) * (1.0 - 1e-15));
                most = std::max(most,
                                (distance + off) / width - std::abs(static_cast<double>(sure[k])));
            }
            EXPECT_EQ(slack, most);
        }
}

// Rounding to the nearest float, which is not enough, is seen to be too far.
TEST(OrientedDistances, NearestFloatsAreTooFar) {
    const std::vector<float> measured = someDistances(1000);
    const auto isTooFar = [](float measured_) {
        const double left = std::abs(static_cast<double>(measured_)) / 61;
        return static_cast<double>(static_cast<float>(left)) > left &&
               static_cast<double>(towardsZero(left * 61, 61)) <= left;
    };
    EXPECT_GT(std::ranges::count_if(measured, isTooFar), 300);
}

TEST(OrientedDistances, InsideIsTurned) {
    const std::vector<std::uint8_t> inside{0, 1, 0, 1, 1};
    std::vector<float> distance{2.0f, 3.0f, 0.0f, 0.0f, 0.25f};
    std::vector<float> awayX{0.6f, 0.6f, 1.0f, 1.0f, 0.0f};
    std::vector<float> awayY{0.8f, -0.8f, 0.0f, 0.0f, 1.0f};
    std::vector<float> shape{0.0f, 1.0f, 0.7f, 0.2f, 0.75f};
    orientTexels({inside, distance, awayX, awayY, shape});
    EXPECT_EQ(distance, (std::vector{2.0f, -3.0f, 0.0f, 0.0f, -0.25f}));
    EXPECT_EQ(awayX,
              (std::vector{0.6f, -0.6f, 1.0f, 1.0f, -0.0f}));  // on the outline they are normals
    EXPECT_EQ(awayY, (std::vector{0.8f, 0.8f, 0.0f, 0.0f, -1.0f}));
    EXPECT_EQ(shape, (std::vector{0.0f, 1.0f, 0.5f, 0.5f, 0.75f}));
}

TEST(OrientedDistances, EveryProcessorGivesTheSameBits) {
    std::vector<float> first;
    for (const Processor processor : kProcessors) {
        const ProcessorLimit limit(processor);
        std::vector<float> sure = someDistances(1003);
        makeDistancesSure(sure, 61, kLongest);
        if (first.empty())
            first = sure;
        EXPECT_EQ(sure, first);
    }
}

}  // namespace
}  // namespace relievo::preprocess
