#include "bench/bake_builders.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "bench/opencv_distances.h"
#include "preprocess/cones_by_levels.h"
#include "preprocess/cones_by_squares.h"
#include "preprocess/normals.h"
#include "preprocess/quick_cones.h"
#include "preprocess/relaxed_cones.h"
#include "preprocess/relaxed_cones_by_maxima.h"
#include "preprocess/relaxed_cones_policarpo.h"
#include "preprocess/roof_cones.h"
#include "preprocess/sequential_distances.h"

namespace relievo::bench {
namespace {

BakeOutput buildDerivatives(const BakeInput& input) {
    preprocess::buildDerivatives(input.map);
    return {};
}

template <int kSectors>
BakeOutput buildRoofs(const BakeInput& input) {
    preprocess::buildRoofCones(input.map, {.sectors = kSectors});
    return {};
}

BakeOutput buildNormals(const BakeInput& input) {
    preprocess::buildNormals(input.derivatives, 0.1);
    return {};
}

BakeOutput buildDistances(const BakeInput& input) {
    preprocess::distancesTo(input.raised, input.map.width(), input.map.height(), input.map.wrap);
    return {};
}

BakeOutput buildSequentialDistances(const BakeInput& input) {
    BakeOutput output;
    output.doubtfulDistances = preprocess::sequentialDistances(input.raised, input.map.width(),
                                                               input.map.height(), input.map.wrap);
    return output;
}

template <auto kBuild, preprocess::ConeGuarantee kGuarantee>
BakeOutput buildExactCones(const BakeInput& input) {
    BakeOutput output;
    output.search.emplace();
    output.ratios = kBuild(input.map, kGuarantee, {}, &*output.search);
    return output;
}

BakeOutput coneOutput(textures::Plane ratios) {
    BakeOutput output;
    output.ratios = std::move(ratios);
    return output;
}

BakeOutput buildConesByLevels(const BakeInput& input) {
    return coneOutput(preprocess::buildConesByLevels(input.map));
}

BakeOutput buildConesBySquares(const BakeInput& input) {
    return coneOutput(preprocess::buildConesBySquares(input.map));
}

BakeOutput buildQuickCones(const BakeInput& input) {
    return coneOutput(preprocess::buildQuickCones(input.map));
}

BakeOutput buildRelaxedByMaxima(const BakeInput& input) {
    return coneOutput(preprocess::buildRelaxedConesByMaxima(input.map));
}

BakeOutput buildRelaxedByRays(const BakeInput& input) {
    return coneOutput(preprocess::buildRelaxedConesByRays(input.map));
}

constexpr std::array kBuilders{
    BakeBuilder{"derivatives", "derivative map from the depth map", 0, buildDerivatives},
    BakeBuilder{"normals", "normal map from the derivative map", 0, buildNormals},
    BakeBuilder{"distances", "exact distances to the upper half", 0, buildDistances},
    BakeBuilder{"distances-4sed", "the same by 4SED", 0, buildSequentialDistances},
    BakeBuilder{"distances-opencv", "the same by OpenCV, never repeated", 0, kOpenCvDistances},
    BakeBuilder{
        "cones-bilinear", "conservative cones, safe on the bilinear surface", 0,
        buildExactCones<preprocess::buildConservativeCones, preprocess::ConeGuarantee::Bilinear>},
    BakeBuilder{
        "cones-texel", "conservative cones between texel centres", 0,
        buildExactCones<preprocess::buildConservativeCones, preprocess::ConeGuarantee::Texel>},
    BakeBuilder{"cones-levels", "conservative cones by 256 depth levels", 0, buildConesByLevels},
    BakeBuilder{"cones-squares", "conservative cones by growing squares", 1024,
                buildConesBySquares},
    BakeBuilder{"cones-quick", "narrower conservative cones by one walk up the pyramid", 0,
                buildQuickCones},
    BakeBuilder{"roof-1", "roof cones of 1 sector", 0, buildRoofs<1>},
    BakeBuilder{"roof-4", "roof cones of 4 sectors", 0, buildRoofs<4>},
    BakeBuilder{"roof-8", "roof cones of 8 sectors", 0, buildRoofs<8>},
    BakeBuilder{
        "relaxed-bilinear", "relaxed cones, safe on the bilinear surface", 0,
        buildExactCones<preprocess::buildRelaxedCones, preprocess::ConeGuarantee::Bilinear>},
    BakeBuilder{"relaxed-texel", "relaxed cones between texel centres", 0,
                buildExactCones<preprocess::buildRelaxedCones, preprocess::ConeGuarantee::Texel>},
    BakeBuilder{"relaxed-maxima", "relaxed cones by 256 levels of local maxima", 0,
                buildRelaxedByMaxima},
    BakeBuilder{"relaxed-policarpo", "relaxed cones by rays between all texels", 64,
                buildRelaxedByRays},
};

std::vector<std::uint8_t> texelsAboveMedian(const textures::Plane& depth) {
    std::vector<float> depths = depth.texels;
    const auto median = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), median, depths.end());
    std::vector<std::uint8_t> raised(depths.size());
    std::transform(depth.texels.begin(), depth.texels.end(), raised.begin(),
                   [limit = *median](float value) {
                       return value < limit ? std::uint8_t{1} : std::uint8_t{0};
                   });
    return raised;
}

}  // namespace

BakeInput makeBakeInput(textures::DepthMap map) {
    BakeInput input;
    input.map = std::move(map);
    input.derivatives = preprocess::buildDerivatives(input.map);
    input.raised = texelsAboveMedian(input.map.depth);
    input.lowered = input.raised;
    for (std::uint8_t& texel : input.lowered)
        texel = static_cast<std::uint8_t>(1 - texel);
    return input;
}

std::span<const BakeBuilder> bakeBuilders() {
    return kBuilders;
}

const BakeBuilder& bakeBuilder(std::string_view name) {
    const auto found = std::find_if(kBuilders.begin(), kBuilders.end(),
                                    [&](const BakeBuilder& entry) { return entry.name == name; });
    if (found == kBuilders.end())
        throw std::invalid_argument("no map builder is called " + std::string(name));
    return *found;
}

}  // namespace relievo::bench
