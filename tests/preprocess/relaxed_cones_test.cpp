#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "preprocess/relaxed_cones.h"
#include "preprocess/relaxed_cones_by_maxima.h"
#include "reference/guarantee_check.h"
#include "tests/preprocess/cone_oracle.h"
#include "textures/sample_reliefs.h"

// Relaxed cones: between texel centres against every chord, with the guarantee Bilinear against the
// bilinear surface sampled densely.

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

// The growth of the depth along (dx,dy) just after (x,y), in the cell that lies there. Growth
// within `tolerance` of none counts as none.
bool growsAfter(const DepthMap& map, double x, double y, double dx, double dy, double tolerance) {
    const auto before = [](double at, double step) {
        const double first = std::floor(at);
        return static_cast<std::int64_t>(step < 0.0 && at == first ? first - 1.0 : first);
    };
    const std::int64_t i = before(x, dx);
    const std::int64_t j = before(y, dy);
    const double u = x - static_cast<double>(i);
    const double v = y - static_cast<double>(j);
    const double d0 = map.at(i, j);
    const double d1 = map.at(i + 1, j);
    const double d2 = map.at(i, j + 1);
    const double d3 = map.at(i + 1, j + 1);
    const double alongX = ((d1 - d0) * (1.0 - v) + (d3 - d2) * v) * dx;
    const double alongY = ((d2 - d0) * (1.0 - u) + (d3 - d1) * u) * dy;
    const double margin = tolerance * (std::abs(alongX) + std::abs(alongY));
    return alongX + alongY > margin || (margin == 0.0 && (d0 - d1 - d2 + d3) * dx * dy > 0.0);
}

double depthAt(const DepthMap& map, double x, double y) {
    const auto i = static_cast<std::int64_t>(std::floor(x));
    const auto j = static_cast<std::int64_t>(std::floor(y));
    const double across = x - static_cast<double>(i);
    const double down = y - static_cast<double>(j);
    const auto row = [&](std::int64_t at) {
        return map.at(i, at) * (1.0 - across) + map.at(i + 1, at) * across;
    };
    return row(j) * (1.0 - down) + row(j + 1) * down;
}

// Points every `step` texels, up to `reachX` and `reachY` from an apex.
struct Points {
    double reachX;
    double reachY;
    double step;
};

// The steepest chord, in texel widths, from (x,y) to points where the depth grows.
double steepestChord(const DepthMap& map, double x, double y, const Points& points,
                     double tolerance) {
    const double depth = depthAt(map, x, y);
    const auto first = [&](double at) { return std::ceil(at / points.step) * points.step; };
    double steepest = 0.0;
    for (double toY = first(y - points.reachY); toY <= y + points.reachY; toY += points.step)
        for (double toX = first(x - points.reachX); toX <= x + points.reachX; toX += points.step) {
            const double length = std::hypot(toX - x, (toY - y) * map.texelAspect);
            const double rise = depth - depthAt(map, toX, toY);
            if (rise > steepest * length && rise > 0.0 &&
                growsAfter(map, toX, toY, toX - x, toY - y, tolerance))
                steepest = rise / length;
        }
    return steepest;
}

double ratioOf(const DepthMap& map, double slope) {
    return slope > 0.0 ? 1.0 / (slope * map.width()) : std::numeric_limits<double>::infinity();
}

// --- Between texel centres ---------------------------------------------------------------------

// How many ratios are not those of all chords to the tile and two copies to each side, where these
// must have the steepest. Growth that rounding may change the sign of may count or not.
int countWrong(const DepthMap& map, const Plane& ratio) {
    const Points points{2.5 * map.width(), 2.5 * map.height(), 1.0};
    const double reach = std::min(2.0 * map.width(), 2.0 * map.height() * map.texelAspect);
    const auto least = *std::min_element(map.depth.texels.begin(), map.depth.texels.end());
    int wrong = 0;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i) {
            const double beyond =
                map.wrap == WrapMode::Clamp ? 0.0 : (map.depth.at(i, j) - least) / reach;
            const double strict = steepestChord(map, i, j, points, 1e-6);
            const double loose = std::max(steepestChord(map, i, j, points, -1e-6), beyond);
            const float built = ratio.at(i, j);
            const bool isRight = built <= ratioOf(map, strict) * (1.0 + 1e-9) &&
                                 built >= ratioOf(map, loose) * (1.0 - 3e-6);
            wrong += isRight ? 0 : 1;
        }
    return wrong;
}

TEST(RelaxedCones, BetweenTexelCentresAreThoseOfAllChords) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] :
             {std::pair{1, 1}, {2, 1}, {1, 7}, {3, 3}, {32, 1}, {17, 11}, {13, 19}})
            for (const int levels : {1 << 20, 3}) {
                DepthMap map = noiseMap(width, height, wrap, 3, levels);
                map.texelAspect = width == 13 ? 1.4 : 1.0;
                EXPECT_EQ(countWrong(map, buildRelaxedCones(map, ConeGuarantee::Texel)), 0)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << levels;
            }
}

// Not the near edge of a plateau counts but the far one.
TEST(RelaxedCones, LookAcrossAPlateau) {
    DepthMap map{Plane(40, 1, 1.0f), WrapMode::Clamp};
    for (int i = 10; i <= 20; ++i)
        map.depth.at(i, 0) = 0.25f;
    const Plane ratio = buildRelaxedCones(map, ConeGuarantee::Texel);
    EXPECT_NEAR(ratio.at(4, 0), 16.0 / 0.75 / 40.0, 1e-6);
    EXPECT_NEAR(ratio.at(25, 0), 15.0 / 0.75 / 40.0, 1e-6);
    EXPECT_EQ(ratio.at(15, 0), std::numeric_limits<float>::infinity());
}

// --- The bilinear surface ----------------------------------------------------------------------

// The widest cone that holds for 5×5 apexes in the square of texel (i,j): no wider one is safe.
double denselySampledRatio(const DepthMap& map, int i, int j) {
    const double reach = std::max(map.width(), map.height());
    double steepest = 0.0;
    for (int b = -2; b <= 2; ++b)
        for (int a = -2; a <= 2; ++a) {
            const double x = i + a / 4.0;
            const double y = j + b / 4.0;
            steepest = std::max({steepest, steepestChord(map, x, y, {2.0, 2.0, 0.125}, 1e-6),
                                 steepestChord(map, x, y, {reach, reach, 1.0}, 1e-6)});
        }
    return ratioOf(map, steepest);
}

struct Tightness {
    double built = 0.0;  // sums of ratios, of at most 1
    double sampled = 0.0;
    int tooWide = 0;
};

Tightness compare(const DepthMap& map, const Plane& ratio, int texels, unsigned seed) {
    std::mt19937 generator(seed);
    Tightness result;
    for (int k = 0; k < texels; ++k) {
        const int i = static_cast<int>(generator() % static_cast<unsigned>(map.width()));
        const int j = static_cast<int>(generator() % static_cast<unsigned>(map.height()));
        const double sampled = denselySampledRatio(map, i, j);
        result.tooWide += ratio.at(i, j) > sampled * (1.0 + 1e-9) ? 1 : 0;
        result.built += std::min(1.0, static_cast<double>(ratio.at(i, j)));
        result.sampled += std::min(1.0, sampled);
    }
    return result;
}

TEST(RelaxedCones, AreSafeAndTightOnEverySample) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        const DepthMap map = textures::generateSampleRelief(sample.name, 64, 64);
        const Tightness result =
            compare(map, buildRelaxedCones(map, ConeGuarantee::Bilinear), 24, 5);
        EXPECT_EQ(result.tooWide, 0) << sample.name;
        EXPECT_GE(result.built, 0.85 * result.sampled) << sample.name;
    }
}

TEST(RelaxedCones, AreSafeInEveryWrapModeAndShape) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] :
             {std::pair{1, 1}, {2, 1}, {1, 7}, {3, 3}, {64, 1}, {17, 11}, {20, 29}}) {
            DepthMap map = noiseMap(width, height, wrap, 7);
            for (const double aspect : {1.0, 0.7, 1.4}) {
                map.texelAspect = aspect;
                const Plane ratio = buildRelaxedCones(map, ConeGuarantee::Bilinear);
                EXPECT_EQ(compare(map, ratio, 3, 1).tooWide, 0)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << aspect;
            }
        }
}

// Where the relief is steep from texel to texel, most cones end beside their squares, and what the
// sampling above steps over is found by rays alone.
TEST(RelaxedCones, AreSafeForRaysOnSteepMaps) {
    for (const std::uint32_t seed : {1u, 5u, 13u}) {
        const DepthMap map = textures::generateSampleRelief("noise", 25, 17, seed);
        reference::GuaranteeCheckOptions options;
        options.rays = 200000;
        const Plane ratio = buildRelaxedCones(map, ConeGuarantee::Bilinear);
        EXPECT_EQ(
            reference::checkCones(map, ratio, reference::ConePromise::Relaxed, options).violations,
            0u)
            << seed;
    }
}

TEST(RelaxedCones, AreUnlimitedWhereNothingIsHigher) {
    const DepthMap flat{Plane(19, 5, 0.5f), WrapMode::Repeat};
    for (const ConeGuarantee guarantee : {ConeGuarantee::Texel, ConeGuarantee::Bilinear})
        for (const float ratio : buildRelaxedCones(flat, guarantee).texels)
            EXPECT_EQ(ratio, std::numeric_limits<float>::infinity());
}

// A slope that goes on rising hides nothing behind it.
TEST(RelaxedCones, AreUnlimitedOnASlopeWithoutACrest) {
    DepthMap map{Plane(50, 30), WrapMode::Clamp};
    for (int j = 0; j < 30; ++j)
        for (int i = 0; i < 50; ++i)
            map.depth.at(i, j) = static_cast<float>(i) / 64.0f;
    for (const float ratio : buildRelaxedCones(map, ConeGuarantee::Texel).texels)
        EXPECT_EQ(ratio, std::numeric_limits<float>::infinity());
    // The surface has a kink where the map ends: squares on it are bounded.
    const Plane ratio = buildRelaxedCones(map, ConeGuarantee::Bilinear);
    for (int j = 0; j < 30; ++j)
        for (int i = 1; i < 49; ++i)
            EXPECT_EQ(ratio.at(i, j), std::numeric_limits<float>::infinity()) << i << " " << j;
}

TEST(RelaxedCones, OfARepeatedMapAreTheCropOfItsMosaic) {
    const DepthMap map = noiseMap(23, 14, WrapMode::Repeat, 9);
    DepthMap mosaic{Plane(69, 42), WrapMode::Repeat};
    for (int j = 0; j < 42; ++j)
        for (int i = 0; i < 69; ++i)
            mosaic.depth.at(i, j) = map.at(i, j);
    for (const ConeGuarantee guarantee : {ConeGuarantee::Texel, ConeGuarantee::Bilinear}) {
        const Plane ratio = buildRelaxedCones(map, guarantee);
        const Plane crop = buildRelaxedCones(mosaic, guarantee);
        for (int j = 0; j < 14; ++j)
            for (int i = 0; i < 23; ++i)
                EXPECT_FLOAT_EQ(ratio.at(i, j), 3.0f * crop.at(i + 23, j + 14));
    }
}

// The wrong variant: a ridge whose crest slopes has no maximum where rays cross it.
TEST(RelaxedConesOracle, CatchesConesByMaximaOnASlopingRidge) {
    DepthMap map{Plane(32, 32), WrapMode::Clamp};
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i)
            map.depth.at(i, j) = std::min(1.0f, 0.1f + 0.01f * static_cast<float>(j) +
                                                    0.1f * static_cast<float>(std::abs(i - 16)));
    EXPECT_GT(compare(map, buildRelaxedConesByMaxima(map), 10, 5).tooWide, 5);
    EXPECT_EQ(compare(map, buildRelaxedCones(map, ConeGuarantee::Bilinear), 8, 5).tooWide, 0);
}

}  // namespace
}  // namespace relievo::preprocess
