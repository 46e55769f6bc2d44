#include "preprocess/processor.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "preprocess/conservative_cones.h"
#include "preprocess/relaxed_cones.h"
#include "preprocess/roof_cones.h"
#include "tests/preprocess/small_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

// All that kernels compute for a map.
std::vector<std::uint32_t> bitsOfAllCones(const DepthMap& map) {
    std::vector<std::uint32_t> bits;
    const auto add = [&](const Plane& plane) {
        for (const float value : plane.texels)
            bits.push_back(std::bit_cast<std::uint32_t>(value));
    };
    for (const ConeGuarantee guarantee : {ConeGuarantee::Texel, ConeGuarantee::Bilinear}) {
        add(buildConservativeCones(map, guarantee));
        for (const int sectors : {1, 4, 8})
            for (const Plane& ratio : buildRelaxedConeSectors(map, guarantee, sectors))
                add(ratio);
    }
    for (const int sectors : {1, 4, 8})
        for (const RoofConeLayer& layer : buildRoofCones(map, {.sectors = sectors})) {
            add(layer.roof);
            add(layer.ratio);
        }
    return bits;
}

std::vector<std::uint32_t> bitsOn(Processor newest, const DepthMap& map) {
    const ProcessorLimit limit(newest);
    return bitsOfAllCones(map);
}

TEST(Processor, LimitEndsWithItsScope) {
    const Processor before = thisProcessor();
    {
        const ProcessorLimit limit(Processor::Baseline);
        EXPECT_EQ(thisProcessor(), Processor::Baseline);
    }
    EXPECT_EQ(thisProcessor(), before);
}

// Generations that the machine lacks are not compared.
TEST(Processor, EveryGenerationGivesTheSameBits) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const DepthMap& map : {noiseMap(49, 31, wrap, 3), hillMap(35, 43, wrap, 1.3)}) {
            const std::vector<std::uint32_t> baseline = bitsOn(Processor::Baseline, map);
            for (const Processor newest : {Processor::Avx2, Processor::Avx512}) {
                if (newest > newestProcessor())
                    continue;
                EXPECT_TRUE(bitsOn(newest, map) == baseline)
                    << textures::wrapModeName(wrap) << " " << static_cast<int>(newest);
            }
        }
}

}  // namespace
}  // namespace relievo::preprocess
