// What all builders of cones on the surface have in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>

#include "preprocess/cones_by_levels.h"
#include "preprocess/cones_by_squares.h"
#include "preprocess/conservative_cones.h"
#include "preprocess/quick_cones.h"
#include "preprocess/relaxed_cones.h"
#include "preprocess/relaxed_cones_by_maxima.h"
#include "preprocess/relaxed_cones_policarpo.h"
#include "preprocess/step_progress.h"
#include "tests/preprocess/thread_limit.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

using Advance = std::function<void(std::size_t)>;

struct Builder {
    const char* name;
    Plane (*build)(const DepthMap& map, const Advance& advance);
    // Long enough for several blocks or rows at a time, short enough for quadratic methods.
    int width;
    int height;
};

template <auto kBuild, ConeGuarantee kGuarantee>
Plane exact(const DepthMap& map, const Advance& advance) {
    return kBuild(map, kGuarantee, advance, nullptr);
}

template <auto kBuild>
Plane byLevels(const DepthMap& map, const Advance& advance) {
    return kBuild(map, 32, advance);
}

// The last of eight: `advance` is called for all of them.
Plane bySectors(const DepthMap& map, const Advance& advance) {
    StepProgress progress(advance, map.depth.texels.size(), 8 * map.depth.texels.size());
    return buildRelaxedConeSectors(map, ConeGuarantee::Bilinear, 8,
                                   [&](std::size_t texels) { progress.done(texels); })
        .back();
}

Plane bySquares(const DepthMap& map, const Advance& advance) {
    return buildConesBySquares(map, advance);
}

class ConeBuilders : public testing::TestWithParam<Builder> {};

TEST_P(ConeBuilders, AreTheSameBytesForOneAndTwoThreadsAndSayHowFarTheyAre) {
    const Builder& builder = GetParam();
    const DepthMap map = textures::generateSampleRelief("cobbles", builder.width, builder.height);
    std::atomic<std::size_t> done{0};
    const auto build = [&] {
        return builder.build(map, [&](std::size_t texels) { done += texels; }).texels;
    };
    EXPECT_EQ(onThreads(1, build), onThreads(2, build));
    EXPECT_EQ(done, 2 * map.depth.texels.size());
}

TEST_P(ConeBuilders, AreUnlimitedWhereNothingIsHigher) {
    for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        for (const auto& [width, height] : {std::pair{1, 1}, {9, 5}})
            for (const float depth : {0.0f, 0.5f, 1.0f}) {
                const Plane ratio = GetParam().build({Plane(width, height, depth), wrap}, {});
                EXPECT_EQ(*std::min_element(ratio.texels.begin(), ratio.texels.end()),
                          std::numeric_limits<float>::infinity())
                    << wrapModeName(wrap) << " " << depth;
            }
}

INSTANTIATE_TEST_SUITE_P(
    All, ConeBuilders,
    testing::Values(
        Builder{"Texel", exact<buildConservativeCones, ConeGuarantee::Texel>, 170, 50},
        Builder{"Bilinear", exact<buildConservativeCones, ConeGuarantee::Bilinear>, 170, 50},
        Builder{"RelaxedTexel", exact<buildRelaxedCones, ConeGuarantee::Texel>, 170, 50},
        Builder{"RelaxedBilinear", exact<buildRelaxedCones, ConeGuarantee::Bilinear>, 170, 50},
        Builder{"RelaxedSectors", bySectors, 170, 50},
        Builder{"Levels", byLevels<buildConesByLevels>, 70, 50},
        Builder{"Squares", bySquares, 70, 50}, Builder{"Quick", buildQuickCones, 70, 50},
        Builder{"Maxima", byLevels<buildRelaxedConesByMaxima>, 70, 50},
        Builder{"Rays", buildRelaxedConesByRays, 20, 14}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace relievo::preprocess
