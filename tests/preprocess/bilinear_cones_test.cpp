#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "preprocess/bilinear_cones.h"
#include "preprocess/conservative_cones.h"
#include "tests/preprocess/cone_oracle.h"
#include "textures/sample_reliefs.h"

// Conservative cones with the guarantee Bilinear, against the bilinear surface sampled densely.

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

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

// The steepest chord, in texels, from (x,y) to the points every `step` texels not farther than
// `reach` along either axis.
double steepestChord(const DepthMap& map, double x, double y, double reach, double step) {
    const double depth = depthAt(map, x, y);
    double steepest = 0.0;
    for (double toY = std::ceil((y - reach) / step) * step; toY <= y + reach; toY += step)
        for (double toX = std::ceil((x - reach) / step) * step; toX <= x + reach; toX += step) {
            const double length = std::hypot(toX - x, (toY - y) * map.texelAspect);
            if (length > 0.0)
                steepest = std::max(steepest, (depth - depthAt(map, toX, toY)) / length);
        }
    return steepest;
}

// The widest cone that holds for 9×9 apexes in the square of texel (i,j): no wider one is safe.
double denselySampledRatio(const DepthMap& map, int i, int j) {
    const double reach =
        std::max(map.width(), map.height()) / (map.wrap == WrapMode::Clamp ? 1.0 : 2.0);
    double steepest = 0.0;
    for (int b = -4; b <= 4; ++b)
        for (int a = -4; a <= 4; ++a) {
            const double x = i + a / 8.0;
            const double y = j + b / 8.0;
            steepest = std::max({steepest, steepestChord(map, x, y, 2.0, 0.125),
                                 steepestChord(map, x, y, reach, 1.0)});
        }
    return steepest > 0.0 ? 1.0 / (steepest * map.width())
                          : std::numeric_limits<double>::infinity();
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

TEST(BilinearCones, AreSafeAndTightOnEverySample) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        const DepthMap map = textures::generateSampleRelief(sample.name, 64, 64);
        const Tightness result =
            compare(map, buildConservativeCones(map, ConeGuarantee::Bilinear), 24, 5);
        EXPECT_EQ(result.tooWide, 0) << sample.name;
        EXPECT_GE(result.built, 0.85 * result.sampled) << sample.name;
    }
}

TEST(BilinearCones, AreSafeInEveryWrapModeAndShape) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] :
             {std::pair{1, 1}, {2, 1}, {1, 7}, {3, 3}, {64, 1}, {17, 11}, {20, 29}}) {
            DepthMap map = noiseMap(width, height, wrap, 7);
            for (const double aspect : {1.0, 0.7, 1.4}) {
                map.texelAspect = aspect;
                const Plane ratio = buildConservativeCones(map, ConeGuarantee::Bilinear);
                EXPECT_EQ(compare(map, ratio, 6, 1).tooWide, 0)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << aspect;
            }
        }
}

// Long-range chords: one high texel far from all others limits every cone.
TEST(BilinearCones, OfASingleSpikeAreLimitedByIt) {
    DepthMap map{Plane(97, 61, 1.0f), WrapMode::Clamp};
    map.depth.at(11, 50) = 0.0f;
    const Plane ratio = buildConservativeCones(map, ConeGuarantee::Bilinear);
    for (const auto& [i, j] : {std::pair{90, 5}, {12, 0}, {40, 50}, {0, 60}}) {
        const double sampled = denselySampledRatio(map, i, j);
        EXPECT_LE(ratio.at(i, j), sampled);
        EXPECT_GE(ratio.at(i, j), 0.95 * sampled);
    }
}

TEST(BilinearCones, AreUnlimitedWhereNothingIsHigher) {
    const DepthMap flat{Plane(19, 5, 0.5f), WrapMode::Repeat};
    for (const float ratio : buildConservativeCones(flat, ConeGuarantee::Bilinear).texels)
        EXPECT_EQ(ratio, std::numeric_limits<float>::infinity());
}

// A stroke of a brush: a dent or a heap with noise on it.
Plane stroke(const DepthMap& map, int left, int top, int size, float by, unsigned seed) {
    std::mt19937 generator(seed);
    Plane depths(size, size);
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i)
            depths.at(i, j) = std::clamp(
                map.depth.at(left + i, top + j) + by * static_cast<float>(generator() % 256) / 255,
                0.0f, 1.0f);
    return depths;
}

TEST(BilinearCones, AfterAnEditAreBitForBitThoseOfANewBuild) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const char* name : {"noise", "pillars", "wave"}) {
            DepthMap map = textures::generateSampleRelief(name, 150, 130);
            map.wrap = wrap;
            BilinearCones cones(map);
            for (const auto& [left, top, by] :
                 {std::tuple{3, 100, -0.4f}, {140, 60, 0.3f}, {70, 1, -1.0f}, {70, 1, 1.0f}}) {
                cones.edit(left, top, stroke(cones.map(), left, top, 9, by, 4));
                const Plane anew = buildConservativeCones(cones.map(), ConeGuarantee::Bilinear);
                ASSERT_EQ(cones.ratio().texels, anew.texels)
                    << name << " " << wrapModeName(wrap) << " " << left << "," << top;
            }
        }
}

TEST(BilinearCones, AfterAnEditThatCannotReachFarAreMostlyKept) {
    BilinearCones cones(textures::generateSampleRelief("noise", 256, 256));
    const std::size_t built = cones.edit(100, 100, stroke(cones.map(), 100, 100, 8, 0.05f, 1));
    EXPECT_LT(built, 256u * 256u / 5u);
    EXPECT_GT(built, 8u * 8u);
    EXPECT_EQ(cones.edit(20, 20, stroke(cones.map(), 20, 20, 8, 0.0f, 1)), 0u);
}

// The wrong variant: cones between texel centres, taken for all of the square.
TEST(BilinearConesOracle, CatchesConesBetweenTexelCentres) {
    for (const char* name : {"noise", "blocks", "lettering"}) {
        const DepthMap map = textures::generateSampleRelief(name, 64, 64);
        const Plane ratio = buildConservativeCones(map, ConeGuarantee::Texel);
        EXPECT_GT(compare(map, ratio, 24, 5).tooWide, 5) << name;
    }
}

}  // namespace
}  // namespace relievo::preprocess
