#include "preprocess/visibility_ellipses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "preprocess/horizon_map.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;

// The ellipse of one texel with these horizons.
VisibilityEllipses ellipseOf(const std::vector<double>& horizons, double scale = 1.0) {
    std::vector<Plane> planes;
    for (const double horizon : horizons)
        planes.emplace_back(1, 1, static_cast<float>(horizon));
    std::vector<const Plane*> views;
    for (const Plane& plane : planes)
        views.push_back(&plane);
    return fitVisibilityEllipses(views, scale);
}

// The tangents under which the border of an ellipse appears that holds the middle of the disk.
std::vector<double> horizonsOfEllipse(double x, double y, double longer, double shorter,
                                      double angle, int azimuths) {
    std::vector<double> tangents;
    for (int k = 0; k < azimuths; ++k) {
        const double direction = azimuthOf(k, azimuths) - angle;
        const double p = std::cos(direction) / longer;
        const double q = std::sin(direction) / shorter;
        const double cx = (-x * std::cos(angle) - y * std::sin(angle)) / longer;
        const double cy = (x * std::sin(angle) - y * std::cos(angle)) / shorter;
        const double a = p * p + q * q;
        const double b = p * cx + q * cy;
        const double radius = (-b + std::sqrt(b * b - a * (cx * cx + cy * cy - 1.0))) / a;
        tangents.push_back(std::sqrt(1.0 / (radius * radius) - 1.0));
    }
    return tangents;
}

TEST(VisibilityEllipses, AreTheUnitDiskOnAPlain) {
    for (const std::size_t azimuths : {3u, 4u, 8u, 16u}) {
        const VisibilityEllipses ellipse = ellipseOf(std::vector<double>(azimuths, 0.0));
        EXPECT_NEAR(ellipse.centreX.at(0, 0), 0.0, 1e-6);
        EXPECT_NEAR(ellipse.centreY.at(0, 0), 0.0, 1e-6);
        EXPECT_NEAR(ellipse.longer.at(0, 0), 1.0, 1e-6);
        EXPECT_NEAR(ellipse.shorter.at(0, 0), 1.0, 1e-6);
        EXPECT_EQ(ellipse.angle.at(0, 0), 0.0f);
    }
}

TEST(VisibilityEllipses, InARoundHoleAreSmallerDisks) {
    for (const double scale : {0.5, 2.0}) {
        const VisibilityEllipses ellipse = ellipseOf(std::vector<double>(8, 1.5), scale);
        const double cosine = 1.0 / std::hypot(1.0, 1.5 * scale);
        EXPECT_NEAR(ellipse.longer.at(0, 0), cosine, 1e-6);
        EXPECT_NEAR(ellipse.shorter.at(0, 0), cosine, 1e-6);
    }
}

TEST(VisibilityEllipses, OfHorizonsAlongAnEllipseAreThatEllipse) {
    for (const double angle : {0.0, 0.6, -1.2, 1.5}) {
        const VisibilityEllipses ellipse =
            ellipseOf(horizonsOfEllipse(0.2, -0.1, 0.7, 0.4, angle, 128));
        EXPECT_NEAR(ellipse.centreX.at(0, 0), 0.2, 2e-3) << angle;
        EXPECT_NEAR(ellipse.centreY.at(0, 0), -0.1, 2e-3) << angle;
        EXPECT_NEAR(ellipse.longer.at(0, 0), 0.7, 2e-3) << angle;
        EXPECT_NEAR(ellipse.shorter.at(0, 0), 0.4, 2e-3) << angle;
        EXPECT_NEAR(ellipse.angle.at(0, 0), angle, 5e-3);
    }
    EXPECT_GT(std::abs(ellipseOf(horizonsOfEllipse(0.2, -0.1, 0.7, 0.4, 0.0, 128)).longer.at(0, 0) -
                       ellipseOf(horizonsOfEllipse(0.2, -0.1, 0.6, 0.4, 0.0, 128)).longer.at(0, 0)),
              5e-2)
        << "another ellipse is told apart";
}

// A groove along the direction of azimuth 0.3, whose walls are at tangents 2·|sin|.
TEST(VisibilityEllipses, InAGrooveAreThinnerAcrossIt) {
    constexpr int kAzimuths = 16;
    std::vector<double> horizons;
    for (int k = 0; k < kAzimuths; ++k)
        horizons.push_back(2.0 * std::abs(std::sin(azimuthOf(k, kAzimuths) - 0.3)));
    const VisibilityEllipses ellipse = ellipseOf(horizons);
    EXPECT_NEAR(ellipse.angle.at(0, 0), 0.3, 0.02);
    EXPECT_LT(ellipse.shorter.at(0, 0), 0.6f * ellipse.longer.at(0, 0));
    EXPECT_NEAR(ellipse.centreX.at(0, 0), 0.0, 1e-6);
    EXPECT_NEAR(ellipse.centreY.at(0, 0), 0.0, 1e-6);
}

TEST(VisibilityEllipses, OfRandomHorizonsHaveAxesInOrderWithinReach) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> tangent(0.0, 5.0);
    for (int k = 0; k < 200; ++k) {
        std::vector<double> horizons(8);
        std::generate(horizons.begin(), horizons.end(), [&] { return tangent(generator); });
        const VisibilityEllipses ellipse = ellipseOf(horizons);
        const float longer = ellipse.longer.at(0, 0);
        const float shorter = ellipse.shorter.at(0, 0);
        EXPECT_GT(shorter, 0.0f);
        EXPECT_LE(shorter, longer);
        EXPECT_LT(longer, 1.2f);
        EXPECT_LT(std::hypot(ellipse.centreX.at(0, 0), ellipse.centreY.at(0, 0)), 1.0f);
        EXPECT_LE(std::abs(ellipse.angle.at(0, 0)), std::numbers::pi / 2 + 1e-6);
    }
}

}  // namespace
}  // namespace relievo::preprocess
