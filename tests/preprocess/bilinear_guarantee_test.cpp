// Cones with the guarantee Bilinear, conservative and relaxed, against the bilinear surface sampled
// densely: never wider, and not much narrower.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "preprocess/conservative_cones.h"
#include "preprocess/relaxed_cones.h"
#include "preprocess/relaxed_cones_by_maxima.h"
#include "tests/preprocess/sampled_cones.h"
#include "tests/preprocess/small_reliefs.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

struct SurfaceCones {
    const char* name;
    Plane (*build)(const DepthMap& map);
    ConeSampling (*sampling)(const DepthMap& map);
    int texelsOfAShape;       // that there is time for
    double tightness = 0.85;  // the least share of the sampled ratios

    [[nodiscard]] Tightness compared(const DepthMap& map, int texels, unsigned seed) const {
        return compareWithSamples(map, build(map), sampling(map), texels, seed);
    }
};

template <auto kBuild>
Plane safeCones(const DepthMap& map) {
    return kBuild(map, ConeGuarantee::Bilinear, {}, nullptr);
}

template <int kNumber, int kSectors>
Plane safeConesOfSector(const DepthMap& map) {
    return buildRelaxedConeSectors(map, ConeGuarantee::Bilinear, kSectors)[kNumber];
}

// Lines of texels have quadrants for octants.
template <int kNumber, int kSectors>
ConeSampling samplingOfSector(const DepthMap& map) {
    const bool isLine = map.width() == 1 || map.height() == 1;
    ConeSampling sampling = relaxedSampling(map);
    sampling.sector = isLine ? SampledSector{kNumber % 4, 4} : SampledSector{kNumber, kSectors};
    return sampling;
}

class BilinearGuarantee : public testing::TestWithParam<SurfaceCones> {};

TEST_P(BilinearGuarantee, IsKeptTightlyOnEverySample) {
    for (const textures::SampleRelief& sample : textures::sampleReliefs()) {
        const DepthMap map = textures::generateSampleRelief(sample.name, 64, 64);
        const Tightness result = GetParam().compared(map, 24, 5);
        EXPECT_EQ(result.tooWide, 0) << sample.name;
        EXPECT_GE(result.built, GetParam().tightness * result.sampled) << sample.name;
    }
}

TEST_P(BilinearGuarantee, IsKeptInEveryWrapModeAndShape) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] :
             {std::pair{1, 1}, {2, 1}, {1, 7}, {3, 3}, {64, 1}, {17, 11}, {20, 29}}) {
            DepthMap map = noiseMap(width, height, wrap, 7);
            for (const double aspect : {1.0, 0.7, 1.4}) {
                map.texelAspect = aspect;
                EXPECT_EQ(GetParam().compared(map, GetParam().texelsOfAShape, 1).tooWide, 0)
                    << width << "x" << height << " " << wrapModeName(wrap) << " " << aspect;
            }
        }
}

// The small MIP levels of long maps: their texels are many times as high as wide, or the other way
// round. In those of one row, which are wider than high, and of one column, the other way round,
// the bound stays of use.
TEST_P(BilinearGuarantee, IsKeptWhereTexelsAreThin) {
    for (const auto& [width, height] : {std::pair{16, 1}, {1, 16}, {9, 7}})
        for (const double aspect : {0.05, 0.2, 5.0, 20.0}) {
            DepthMap map = noiseMap(width, height, WrapMode::Repeat, 7);
            map.texelAspect = aspect;
            const Tightness result = GetParam().compared(map, GetParam().texelsOfAShape, 1);
            EXPECT_EQ(result.tooWide, 0) << width << "x" << height << " " << aspect;
            const bool isLevel = aspect < 1.0 ? height == 1 : width == 1;
            EXPECT_GT(result.built, isLevel ? 0.5 * result.sampled : 0.0)
                << width << "x" << height << " " << aspect;
        }
}

// Cells on the border of a sector count with chords of their parts beyond it.
constexpr double kInASector = 0.72;

INSTANTIATE_TEST_SUITE_P(
    All, BilinearGuarantee,
    testing::Values(SurfaceCones{"Conservative", safeCones<buildConservativeCones>,
                                 conservativeSampling, 6},
                    SurfaceCones{"Relaxed", safeCones<buildRelaxedCones>, relaxedSampling, 3},
                    SurfaceCones{"RelaxedInAQuadrant", safeConesOfSector<1, 4>,
                                 samplingOfSector<1, 4>, 3, kInASector},
                    SurfaceCones{"RelaxedInAShallowOctant", safeConesOfSector<0, 8>,
                                 samplingOfSector<0, 8>, 3, kInASector},
                    SurfaceCones{"RelaxedInASteepOctant", safeConesOfSector<7, 8>,
                                 samplingOfSector<7, 8>, 3, kInASector}),
    [](const auto& tested) { return std::string(tested.param.name); });

// The wrong variant: cones between texel centres, taken for all of the square.
TEST(BilinearGuaranteeOracle, CatchesConesBetweenTexelCentres) {
    for (const char* name : {"noise", "blocks", "lettering"}) {
        const DepthMap map = textures::generateSampleRelief(name, 64, 64);
        const Plane ratio = buildConservativeCones(map, ConeGuarantee::Texel);
        EXPECT_GT(compareWithSamples(map, ratio, conservativeSampling(map), 24, 5).tooWide, 5)
            << name;
    }
}

// The wrong variant: a ridge whose crest slopes has no maximum where rays cross it.
TEST(BilinearGuaranteeOracle, CatchesConesByMaximaOnASlopingRidge) {
    DepthMap map{Plane(32, 32), WrapMode::Clamp};
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i)
            map.depth.at(i, j) = std::min(1.0f, 0.1f + 0.01f * static_cast<float>(j) +
                                                    0.1f * static_cast<float>(std::abs(i - 16)));
    const ConeSampling sampling = relaxedSampling(map);
    const Plane unsafe = buildRelaxedConesByMaxima(map);
    EXPECT_GT(compareWithSamples(map, unsafe, sampling, 10, 5).tooWide, 5);
    const Plane safe = buildRelaxedCones(map, ConeGuarantee::Bilinear);
    EXPECT_EQ(compareWithSamples(map, safe, sampling, 8, 5).tooWide, 0);
}

}  // namespace
}  // namespace relievo::preprocess
