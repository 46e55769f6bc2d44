#include "preprocess/cone_encoding.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

using textures::ConeEncoding;
using textures::Plane;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Plane row(std::vector<float> values) {
    Plane plane(static_cast<int>(values.size()), 1);
    plane.texels = std::move(values);
    return plane;
}

TEST(ConeEncoding, RadiusIsTheRatioTimesTheDepth) {
    const Plane radius =
        encodeCones(row({0.5f, 2.0f, 0.25f}), row({0.5f, 1.0f, 0.0f}), ConeEncoding::Radius);
    EXPECT_FLOAT_EQ(radius.texels[0], 0.25f);
    EXPECT_FLOAT_EQ(radius.texels[1], 2.0f);
    EXPECT_EQ(radius.texels[2], 0.0f);
}

TEST(ConeEncoding, UnlimitedStaysUnlimitedAlsoAtDepthZero) {
    const Plane ratio = row({kInfinity, kInfinity});
    const Plane depth = row({0.0f, 0.5f});
    for (const ConeEncoding encoding : {ConeEncoding::Ratio, ConeEncoding::Radius}) {
        const Plane cone = encodeCones(ratio, depth, encoding);
        EXPECT_EQ(cone.texels, ratio.texels);
        EXPECT_EQ(decodeCones(cone, depth, encoding).texels, ratio.texels);
    }
}

TEST(ConeEncoding, ComesBackNeverWider) {
    std::mt19937 generator(1);
    const auto random = [&] { return static_cast<float>(generator()) / 4294967296.0f; };
    Plane ratio(5000, 1);
    Plane depth(5000, 1);
    for (std::size_t k = 0; k < 5000; ++k) {
        ratio.texels[k] = 3.0f * random();
        depth.texels[k] = random() + 1e-6f;
    }
    const Plane back =
        decodeCones(encodeCones(ratio, depth, ConeEncoding::Radius), depth, ConeEncoding::Radius);
    bool rounded = false;
    for (std::size_t k = 0; k < 5000; ++k) {
        EXPECT_LE(back.texels[k], ratio.texels[k]);
        EXPECT_GE(back.texels[k], ratio.texels[k] * (1.0f - 5e-7f));
        // The wrong variant: rounding to the nearest would sometimes come back wider.
        rounded = rounded || ratio.texels[k] * depth.texels[k] / depth.texels[k] > ratio.texels[k];
    }
    EXPECT_TRUE(rounded);
}

TEST(RoundDown, IsTheLargestFloatThatIsNotAbove) {
    EXPECT_EQ(roundDown(0.5), 0.5f);
    EXPECT_LT(static_cast<double>(roundDown(0.1)), 0.1);
    EXPECT_GT(static_cast<double>(std::nextafter(roundDown(0.1), 1.0f)), 0.1);
    EXPECT_EQ(roundDown(1e300), std::numeric_limits<float>::max());
    EXPECT_EQ(roundDown(0.0), 0.0f);
}

}  // namespace
}  // namespace relievo::preprocess
