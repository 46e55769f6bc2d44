#include "preprocess/derivatives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "preprocess/normals.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr double kPi = std::numbers::pi;

// D = ½ + ⅛·sin(2πu) + ⅛·cos(2πv): twice as wide as high, so that v runs through half a tile width.
DepthMap wave(int width, int height) {
    DepthMap map{Plane(width, height), WrapMode::Repeat};
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            map.depth.at(i, j) =
                static_cast<float>(0.5 + 0.125 * std::sin(2 * kPi * (i + 0.5) / width) +
                                   0.125 * std::cos(2 * kPi * (j + 0.5) / height));
    return map;
}

TEST(Derivatives, OfARampAreItsSlopesPerTileWidth) {
    DepthMap ramp{Plane(64, 32), WrapMode::Clamp};
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 64; ++i)
            ramp.depth.at(i, j) = static_cast<float>(i) / 128.0f + static_cast<float>(j) / 256.0f;
    const Derivatives derivatives = buildDerivatives(ramp);
    for (int j = 1; j < 31; ++j)
        for (int i = 1; i < 63; ++i) {
            EXPECT_FLOAT_EQ(derivatives.dx.at(i, j), 0.5f);
            EXPECT_FLOAT_EQ(derivatives.dy.at(i, j), 0.25f);
        }
    // Clamp: the border texel stands in for the one outside, so the slope there is halved.
    EXPECT_FLOAT_EQ(derivatives.dx.at(0, 5), 0.25f);
    EXPECT_FLOAT_EQ(derivatives.dy.at(5, 31), 0.125f);
}

TEST(Derivatives, OfTexelsThatAreNoSquaresAreStillPerTileWidth) {
    DepthMap ramp{Plane(8, 6), WrapMode::Clamp};
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 8; ++i)
            ramp.depth.at(i, j) = static_cast<float>(i + j) / 16.0f;
    ramp.texelAspect = 1.25;
    EXPECT_DOUBLE_EQ(ramp.aspect(), 1.25 * 6 / 8);
    const Derivatives derivatives = buildDerivatives(ramp);
    EXPECT_FLOAT_EQ(derivatives.dx.at(3, 3), 0.5f);
    EXPECT_FLOAT_EQ(derivatives.dy.at(3, 3), 0.5f / 1.25f);
}

TEST(Derivatives, OfAWaveAreItsClosedFormInTheMetric) {
    const int width = 256;
    const int height = 128;
    const Derivatives derivatives = buildDerivatives(wave(width, height));
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double u = (i + 0.5) / width;
            const double v = (j + 0.5) / height;
            // A central difference of a wave is the true slope times sin(δ)/δ: 6e-4 less here.
            EXPECT_NEAR(derivatives.dx.at(i, j), 0.25 * kPi * std::cos(2 * kPi * u), 6e-4);
            const double perTileWidth = static_cast<double>(width) / height;
            EXPECT_NEAR(derivatives.dy.at(i, j), -0.25 * kPi * perTileWidth * std::sin(2 * kPi * v),
                        1e-3);
        }
}

TEST(Derivatives, FollowTheWrapModeAtTheBorder) {
    DepthMap map{Plane(4, 1), WrapMode::Repeat};
    map.depth.texels = {0.0f, 0.25f, 0.5f, 1.0f};
    EXPECT_FLOAT_EQ(buildDerivatives(map).dx.at(0, 0), (0.25f - 1.0f) * 2);
    EXPECT_FLOAT_EQ(buildDerivatives(map).dy.at(0, 0), 0.0f);
    map.wrap = WrapMode::Mirror;
    EXPECT_FLOAT_EQ(buildDerivatives(map).dx.at(0, 0), (0.25f - 0.0f) * 2);
    EXPECT_FLOAT_EQ(buildDerivatives(map).dx.at(3, 0), (1.0f - 0.5f) * 2);
}

TEST(Derivatives, OfASingleTexelAreZero) {
    const Derivatives derivatives = buildDerivatives({Plane(1, 1, 0.3f), WrapMode::Repeat});
    EXPECT_EQ(derivatives.dx.at(0, 0), 0.0f);
    EXPECT_EQ(derivatives.dy.at(0, 0), 0.0f);
}

TEST(Normals, AreUnitLeanAlongTheSlopeOfDepthAndFollowTheScale) {
    const Derivatives derivatives = buildDerivatives(wave(64, 64));
    for (const double scale : {0.0, 0.1, 3.0}) {
        const Normals normals = buildNormals(derivatives, scale);
        for (std::size_t k = 0; k < normals.nx.texels.size(); ++k) {
            const double x = normals.nx.texels[k];
            const double y = normals.ny.texels[k];
            const double z = normals.nz.texels[k];
            EXPECT_NEAR(x * x + y * y + z * z, 1.0, 1e-6);
            EXPECT_NEAR(x / z, scale * derivatives.dx.texels[k], 1e-6);
            EXPECT_NEAR(y / z, scale * derivatives.dy.texels[k], 1e-6);
        }
    }
}

TEST(Normals, OfAFlatReliefAreStraight) {
    const Normals normals = buildNormals(buildDerivatives(wave(16, 16)), 0.0);
    for (std::size_t k = 0; k < normals.nx.texels.size(); ++k) {
        EXPECT_EQ(normals.nx.texels[k], 0.0f);
        EXPECT_EQ(normals.ny.texels[k], 0.0f);
        EXPECT_EQ(normals.nz.texels[k], 1.0f);
    }
}

}  // namespace
}  // namespace relievo::preprocess
