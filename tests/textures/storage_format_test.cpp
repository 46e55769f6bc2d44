#include "textures/storage_format.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "random_planes.h"
#include "textures/channel_coding.h"

namespace relievo::textures {
namespace {

constexpr std::array kFormats{StorageFormat::Float, StorageFormat::Half, StorageFormat::U16,
                              StorageFormat::U8};
constexpr std::array kEncodings{ConeEncoding::Ratio, ConeEncoding::Sqrt};
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Ratios over many orders of magnitude, with zeros, an infinite one and one above the range.
Plane randomRatios() {
    Plane ratios = randomPlane(64, 64, -14.0f, 1.0f, 17);
    for (float& value : ratios.texels)
        value = std::exp2(value);
    ratios.texels[0] = 0.0f;
    ratios.texels[1] = kInfinity;
    ratios.texels[2] = 1e6f;
    ratios.texels[3] = std::numeric_limits<float>::denorm_min();
    return ratios;
}

int countAbove(const Plane& stored, const Plane& truth) {
    int count = 0;
    for (std::size_t t = 0; t < truth.texels.size(); ++t)
        count += stored.texels[t] > truth.texels[t] ? 1 : 0;
    return count;
}

TEST(StorageFormat, NamesAreInverse) {
    for (const StorageFormat format : kFormats)
        EXPECT_EQ(storageFormatFromName(storageFormatName(format)), format);
    EXPECT_FALSE(storageFormatFromName("u32"));
}

TEST(StorageFormat, ConesAreNeverAboveTheTruth) {
    const Plane ratios = randomRatios();
    for (const StorageFormat format : kFormats)
        for (const ConeEncoding encoding : kEncodings)
            for (const char* name : {"cone", "ratio", "roof", "ratio3"}) {
                EXPECT_EQ(countAbove(storedValues(ratios, name, format, encoding), ratios), 0)
                    << storageFormatName(format) << " " << name;
            }
    // Rounding to the nearest, as other channels are, must fail this very check.
    const Plane finite = randomPlane(64, 64, 0.0f, 0.8f, 18);
    EXPECT_GT(countAbove(storedValues(finite, "dx", StorageFormat::Half), finite), 1000);
    EXPECT_GT(countAbove(storedValues(finite, "depth", StorageFormat::U8), finite), 1000);
}

int countFarther(const Plane& stored, const Plane& truth) {
    int count = 0;
    for (std::size_t t = 0; t < truth.texels.size(); ++t)
        count += std::abs(stored.texels[t]) > std::abs(truth.texels[t]) ||
                         stored.texels[t] * truth.texels[t] < 0.0f
                     ? 1
                     : 0;
    return count;
}

TEST(StorageFormat, DistancesAreNeverFartherFromZero) {
    Plane distances = randomPlane(64, 64, -0.31f, 0.47f, 31);
    distances.texels[7] = 0.0f;
    distances.texels[8] = -1e-9f;
    const Plane outside = randomPlane(64, 64, 0.0f, 0.47f, 32);
    for (const StorageFormat format : kFormats) {
        const Plane stored = storedValues(distances, "distance", format);
        EXPECT_EQ(countFarther(stored, distances), 0) << storageFormatName(format);
        EXPECT_EQ(stored.texels[7], 0.0f);
        EXPECT_EQ(countFarther(storedValues(outside, "distance", format), outside), 0);
    }
    // Rounding to the nearest or down must fail this very check.
    EXPECT_GT(countFarther(storedValues(distances, "dx", StorageFormat::U8), distances), 1000);
    EXPECT_GT(countFarther(storedValues(distances, "vdm", StorageFormat::Half), distances), 1000);
}

TEST(StorageFormat, DistancesLoseLessThanOneCode) {
    const Plane distances = randomPlane(40, 40, -0.31f, 0.47f, 33);
    const Plane outside = randomPlane(40, 40, 0.0f, 0.47f, 34);
    for (const StorageFormat format : {StorageFormat::U16, StorageFormat::U8}) {
        const Plane stored = storedValues(distances, "distance", format);
        const Plane unsignedOnes = storedValues(outside, "distance", format);
        for (std::size_t t = 0; t < distances.texels.size(); ++t) {
            EXPECT_LT(std::abs(distances.texels[t] - stored.texels[t]),
                      1.01 * 2.0 * 0.47 / (maximumCode(format) - 1.0));
            EXPECT_LT(outside.texels[t] - unsignedOnes.texels[t], 0.4701 / maximumCode(format));
        }
    }
}

TEST(StorageFormat, ConesLoseLessThanOneCode) {
    const Plane ratios = randomPlane(40, 40, 0.0f, 0.8f, 23);
    for (const StorageFormat format : {StorageFormat::U16, StorageFormat::U8}) {
        const Plane stored = storedValues(ratios, "cone", format);
        for (std::size_t t = 0; t < ratios.texels.size(); ++t)
            EXPECT_LT(ratios.texels[t] - stored.texels[t], 0.8001 / maximumCode(format));
    }
}

TEST(StorageFormat, InfiniteRatiosBecomeTheWidest) {
    const Plane ratios = randomRatios();
    EXPECT_EQ(storedValues(ratios, "cone", StorageFormat::Float).texels[1], 65504.0f);
    EXPECT_EQ(storedValues(ratios, "cone", StorageFormat::Half).texels[1], 65504.0f);
    EXPECT_EQ(storedValues(ratios, "cone", StorageFormat::U16).texels[1], 1.0f);
    const Plane flat(2, 2, kInfinity);
    EXPECT_EQ(storedValues(flat, "cone", StorageFormat::U8).texels[0], 1.0f);
    Plane narrow(2, 1, 0.25f);
    narrow.texels[1] = kInfinity;
    EXPECT_EQ(storedValues(narrow, "cone", StorageFormat::U8).texels, (std::vector{0.25f, 0.25f}));
}

TEST(StorageFormat, DepthsRoundToTheNearestCode) {
    const Plane depths = randomPlane(64, 64, 0.0f, 1.0f, 4);
    for (const StorageFormat format : {StorageFormat::U16, StorageFormat::U8}) {
        const Plane stored = storedValues(depths, "depth", format);
        const double maximum = maximumCode(format);
        for (std::size_t t = 0; t < depths.texels.size(); ++t)
            EXPECT_EQ(stored.texels[t],
                      static_cast<float>(std::round(depths.texels[t] * maximum) / maximum));
    }
}

TEST(StorageFormat, HalvesAreThoseOfTheHalfType) {
    Plane values = randomPlane(128, 64, -20.0f, 15.9f, 8);
    for (std::size_t t = 0; t < values.texels.size(); ++t)
        values.texels[t] = std::copysign(std::exp2(values.texels[t]), t % 2 == 0 ? 1.0f : -1.0f);
    const Plane stored = storedValues(values, "dx", StorageFormat::Half);
    const int count = static_cast<int>(values.texels.size());
    std::vector<std::uint16_t> halves(values.texels.size());
    std::vector<float> expected(values.texels.size());
    OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, values.texels.data(), OIIO::TypeDesc::HALF,
                               halves.data(), count);
    OIIO::convert_pixel_values(OIIO::TypeDesc::HALF, halves.data(), OIIO::TypeDesc::FLOAT,
                               expected.data(), count);
    EXPECT_EQ(stored.texels, expected);
}

TEST(StorageFormat, ASecondPassChangesNothing) {
    for (const auto& [name, values] : {std::pair{"depth", randomPlane(31, 31, 0.0f, 1.0f, 1)},
                                       {"cone", randomRatios()},
                                       {"dx", randomPlane(31, 31, -3.7f, 2.9f, 2)},
                                       {"dy", randomPlane(31, 31, 0.0f, 711.0f, 3)},
                                       {"nz", randomPlane(31, 31, 0.1f, 1.0f, 4)},
                                       {"distance", randomPlane(31, 31, -0.3f, 2.0f, 5)},
                                       {"distance", randomPlane(31, 31, 0.0f, 2.0f, 6)}})
        for (const StorageFormat format : kFormats)
            for (const ConeEncoding encoding : kEncodings) {
                const Plane once = storedValues(values, name, format, encoding);
                EXPECT_EQ(storedValues(once, name, format, encoding).texels, once.texels)
                    << name << " " << storageFormatName(format);
            }
}

TEST(StorageFormat, ZeroOfSignedChannelsIsExact) {
    for (const StorageFormat format : {StorageFormat::U16, StorageFormat::U8})
        for (const char* name : {"dx", "dy", "nx", "ny", "nz", "gx", "gy"})
            for (std::uint32_t seed = 1; seed < 20; ++seed) {
                Plane values =
                    randomPlane(16, 16, -std::exp2(static_cast<float>(seed) - 9.0f), 1.3f, seed);
                values.texels[5] = 0.0f;
                const Plane stored = storedValues(values, name, format);
                EXPECT_EQ(stored.texels[5], 0.0f);
                const ChannelRange range =
                    channelCoding(std::array{&std::as_const(values)}, name, format).range;
                const double step = (range.high - range.low) / maximumCode(format);
                for (std::size_t t = 0; t < values.texels.size(); ++t)
                    EXPECT_LE(std::abs(stored.texels[t] - values.texels[t]), 0.50001 * step);
            }
}

TEST(StorageFormat, ConstantChannelsKeepTheirValue) {
    for (const StorageFormat format : kFormats) {
        EXPECT_EQ(storedValues(Plane(3, 2, 0.0f), "dx", format).texels, Plane(3, 2, 0.0f).texels);
        EXPECT_EQ(storedValues(Plane(3, 2, 0.0f), "cone", format).texels, Plane(3, 2).texels);
        EXPECT_EQ(storedValues(Plane(1, 1, 1.0f), "depth", format).texels.front(), 1.0f);
    }
}

// What the smallest code stands for is a cone of the map, not nothing.
TEST(StorageFormat, NoPositiveConeVanishes) {
    Plane ratios = randomRatios();
    ratios.texels[0] = 0.5f;
    for (const StorageFormat format : kFormats)
        for (const ConeEncoding encoding : kEncodings)
            for (const char* name : {"cone", "ratio2"}) {
                // Half ends at 6e-8: below it there is nothing but 0.
                if (format == StorageFormat::Half)
                    ratios.texels[3] = 1e-7f;
                EXPECT_EQ(storageLoss(ratios, name, format, encoding).vanishing, 0u);
                const Plane stored = storedValues(ratios, name, format, encoding);
                EXPECT_GT(*std::min_element(stored.texels.begin(), stored.texels.end()), 0.0f);
            }
}

TEST(StorageFormat, ZeroStaysZeroAndMayTakeNarrowConesWithIt) {
    Plane ratios(4, 1, 0.5f);
    ratios.texels[0] = 0.0f;        // was zero: a stall, but not from rounding
    ratios.texels[1] = 0.5f / 256;  // below the first of 255 codes
    EXPECT_EQ(storedValues(ratios, "cone", StorageFormat::U8).texels[0], 0.0f);
    EXPECT_EQ(storageLoss(ratios, "cone", StorageFormat::U8).vanishing, 1u);
    EXPECT_EQ(storageLoss(ratios, "cone", StorageFormat::U16).vanishing, 0u);
    EXPECT_EQ(storageLoss(ratios, "cone", StorageFormat::Float).vanishing, 0u);
    const StorageLoss root = storageLoss(ratios, "cone", StorageFormat::U8, ConeEncoding::Sqrt);
    EXPECT_EQ(root.vanishing, 0u) << "a root leaves room for it";
}

TEST(StorageFormat, RootsKeepMoreOfNarrowCones) {
    Plane ratios = randomPlane(64, 64, -8.0f, 0.0f, 5);
    for (float& value : ratios.texels)
        value = std::exp2(value);
    const StorageLoss even = storageLoss(ratios, "cone", StorageFormat::U8);
    const StorageLoss root = storageLoss(ratios, "cone", StorageFormat::U8, ConeEncoding::Sqrt);
    EXPECT_EQ(even.cones, ratios.texels.size());
    EXPECT_GT(root.meanShare, even.meanShare);
    EXPECT_GT(root.worstShare, even.worstShare);
    EXPECT_LE(root.meanShare, 1.0);
    // Depths and roofs are not stored as roots, and floats need none.
    const Plane values = randomPlane(9, 9, 0.0f, 1.0f, 6);
    for (const char* name : {"depth", "roof1", "dx"})
        EXPECT_EQ(storedValues(values, name, StorageFormat::U8, ConeEncoding::Sqrt).texels,
                  storedValues(values, name, StorageFormat::U8).texels);
    EXPECT_EQ(storedValues(values, "cone", StorageFormat::Float, ConeEncoding::Sqrt).texels,
              values.texels);
}

TEST(StorageFormat, LossIsThatOfTheStoredValues) {
    Plane ratios = randomRatios();
    for (const StorageFormat format : kFormats)
        for (const ConeEncoding encoding : kEncodings) {
            const Plane stored = storedValues(ratios, "ratio", format, encoding);
            double sum = 0.0;
            double worst = 1.0;
            std::size_t count = 0;
            for (std::size_t t = 0; t < ratios.texels.size(); ++t)
                if (ratios.texels[t] > 0.0f && std::isfinite(ratios.texels[t])) {
                    const double share = static_cast<double>(stored.texels[t]) / ratios.texels[t];
                    sum += share;
                    worst = std::min(worst, share);
                    ++count;
                }
            const StorageLoss loss = storageLoss(ratios, "ratio", format, encoding);
            EXPECT_EQ(loss.cones, count);
            EXPECT_DOUBLE_EQ(loss.meanShare, sum / static_cast<double>(count));
            EXPECT_DOUBLE_EQ(loss.worstShare, worst);
            EXPECT_EQ(loss.widest, isPackedFormat(format) ? 1.0 : kLargestHalf);
            EXPECT_EQ(loss.narrowed > 0, true) << "one ratio is a million";
        }
    EXPECT_EQ(storageLoss(Plane(2, 2, kInfinity), "cone", StorageFormat::U8).meanShare, 1.0);
}

}  // namespace
}  // namespace relievo::textures
