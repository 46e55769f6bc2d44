#include "bench/bake_builders.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "bench/opencv_distances.h"
#include "preprocess/cone_kinds.h"
#include "preprocess/cones_by_levels.h"
#include "preprocess/cones_by_squares.h"
#include "preprocess/map_kinds.h"
#include "preprocess/normals.h"
#include "preprocess/quick_cones.h"
#include "preprocess/relaxed_cones.h"
#include "preprocess/relaxed_cones_by_maxima.h"
#include "preprocess/relaxed_cones_policarpo.h"
#include "preprocess/relief_baker.h"
#include "preprocess/roof_cones.h"
#include "preprocess/sequential_distances.h"
#include "preprocess/shape_baker.h"

namespace relievo::bench {
namespace {

using preprocess::buildConservativeCones;
using preprocess::buildRelaxedCones;
using preprocess::ConeGuarantee;

template <typename Maps>
BakeOutput otherOutput(Maps maps) {
    BakeOutput output;
    output.others = std::move(maps);
    return output;
}

BakeOutput coneOutput(textures::Plane ratios) {
    BakeOutput output;
    output.ratios = std::move(ratios);
    return output;
}

BakeOutput buildDerivatives(const BakeInput& input) {
    return otherOutput(preprocess::buildDerivatives(input.map));
}

BakeOutput buildNormals(const BakeInput& input) {
    return otherOutput(preprocess::buildNormals(input.derivatives, 0.1));
}

BakeOutput buildDistances(const BakeInput& input) {
    return otherOutput(preprocess::distancesTo(input.raised, input.map.width(), input.map.height(),
                                               input.map.wrap));
}

// The raised texels as coverage with grey between them, as a drawn shape has it: a half where the
// median is.
template <bool kHasSharpCorners>
BakeOutput buildShape(const BakeInput& input) {
    preprocess::ShapePlan plan;
    plan.wrap = input.map.wrap;
    plan.hasSharpCorners = kHasSharpCorners;
    return otherOutput(preprocess::bakeShape(input.shape, plan));
}

BakeOutput buildSequentialDistances(const BakeInput& input) {
    BakeOutput output;
    output.doubtfulDistances = preprocess::sequentialDistances(input.raised, input.map.width(),
                                                               input.map.height(), input.map.wrap);
    return output;
}

template <auto kBuild, ConeGuarantee kGuarantee>
BakeOutput buildExactCones(const BakeInput& input) {
    BakeOutput output;
    output.search.emplace();
    output.ratios = kBuild(input.map, kGuarantee, {}, &*output.search);
    return output;
}

BakeOutput buildConesByLevels(const BakeInput& input) {
    return coneOutput(preprocess::buildConesByLevels(input.map));
}

// Quadratic: of larger maps only so many texels are built, on a lattice. An odd number of texels
// apart, they meet the features of a relief that repeats them at many places.
BakeOutput buildConesBySquares(const BakeInput& input) {
    constexpr double kMostTexels = 4096;
    const auto texels = static_cast<double>(input.map.depth.texels.size());
    const int step =
        texels <= kMostTexels ? 1 : static_cast<int>(std::sqrt(texels / kMostTexels)) | 1;
    return coneOutput(preprocess::buildConesBySquares(input.map, {}, step));
}

BakeOutput buildQuickCones(const BakeInput& input) {
    return coneOutput(preprocess::buildQuickCones(input.map));
}

template <int kSectors>
BakeOutput buildRoofs(const BakeInput& input) {
    BakeOutput output;
    output.search.emplace();
    output.others =
        preprocess::buildRoofCones(input.map, {.sectors = kSectors}, {}, &*output.search);
    return output;
}

template <int kSectors>
BakeOutput buildRelaxedSectors(const BakeInput& input) {
    BakeOutput output;
    output.search.emplace();
    output.others = preprocess::buildRelaxedConeSectors(input.map, ConeGuarantee::Bilinear,
                                                        kSectors, {}, &*output.search);
    return output;
}

BakeOutput buildRelaxedByMaxima(const BakeInput& input) {
    return coneOutput(preprocess::buildRelaxedConesByMaxima(input.map));
}

BakeOutput buildRelaxedByRays(const BakeInput& input) {
    return coneOutput(preprocess::buildRelaxedConesByRays(input.map));
}

// --- Entries -----------------------------------------------------------------------------------

// What relievo-bake counts on for cones in these words.
double statedBytes(const char* cone, const char* guarantee, const char* method) {
    preprocess::ReliefPlan plan;
    plan.cone = cone;
    plan.guarantee = guarantee;
    plan.method = method;
    return preprocess::findConeKind(plan)->workingBytes;
}

// Limits of size are such that all builders together take minutes, not hours, on a relief of 4096².
constexpr std::string_view kDistances = "distances";
constexpr std::string_view kShape = "shape";
constexpr std::string_view kCones = "cones";
constexpr std::string_view kRelaxed = "relaxed cones";

std::vector<BakeBuilder> surfaceBuilders() {
    return {
        {"derivatives", "derivative map from the depth map", buildDerivatives},
        {"normals", "normal map from the derivative map", buildNormals},
        {"distances", "exact distances to the upper half", buildDistances, 0, kDistances},
        {"distances-4sed", "the same by 4SED", buildSequentialDistances, 0, kDistances, true},
        {"distances-opencv", "the same by OpenCV, never repeated", kOpenCvDistances, 0, kDistances,
         true},
        {"shape", "shape map of the upper half: outline, signed distances, directions",
         buildShape<false>, 0, kShape},
        {"shape-sharp", "the same with sharp corners", buildShape<true>, 0, kShape},
        {"shape-opencv", "its like by OpenCV: distances of both sides and Sobel, never repeated",
         kOpenCvShape, 0, kShape, true},
    };
}

std::vector<BakeBuilder> coneBuilders() {
    return {
        {"cones-bilinear", "conservative cones, safe on the bilinear surface",
         buildExactCones<buildConservativeCones, ConeGuarantee::Bilinear>, 0, kCones, false,
         statedBytes("conservative", "bilinear", "exact")},
        {"cones-texel", "conservative cones between texel centres",
         buildExactCones<buildConservativeCones, ConeGuarantee::Texel>, 0, kCones, false,
         statedBytes("conservative", "texel", "exact")},
        {"cones-levels", "conservative cones by 256 depth levels", buildConesByLevels, 1024, kCones,
         true, statedBytes("conservative", "texel", "levels")},
        {"cones-squares", "conservative cones by growing squares, of larger maps for some texels",
         buildConesBySquares, 1024, kCones, true, statedBytes("conservative", "texel", "squares")},
        {"cones-quick", "narrower conservative cones by one walk up the pyramid", buildQuickCones,
         512, kCones, true, statedBytes("conservative", "texel", "quick")},
        {"roof-1", "roof cones of 1 sector", buildRoofs<1>, 0, "", false,
         statedBytes("roof", "", "")},
        {"roof-4", "roof cones of 4 sectors", buildRoofs<4>, 2048, "", false,
         statedBytes("roof", "", "")},
        {"roof-8", "roof cones of 8 sectors", buildRoofs<8>, 512, "", false,
         statedBytes("roof", "", "")},
        {"relaxed-bilinear", "relaxed cones, safe on the bilinear surface",
         buildExactCones<buildRelaxedCones, ConeGuarantee::Bilinear>, 2048, kRelaxed, false,
         statedBytes("relaxed", "bilinear", "")},
        {"relaxed-8", "the same for 8 sectors of directions", buildRelaxedSectors<8>, 512, "",
         false, statedBytes("relaxed", "bilinear", "")},
        {"relaxed-texel", "relaxed cones between texel centres",
         buildExactCones<buildRelaxedCones, ConeGuarantee::Texel>, 2048, kRelaxed, false,
         statedBytes("relaxed", "texel", "")},
        {"relaxed-maxima", "relaxed cones by 256 levels of local maxima", buildRelaxedByMaxima, 512,
         kRelaxed, true, statedBytes("relaxed", "none", "maxima")},
        {"relaxed-policarpo", "relaxed cones by rays between all texels", buildRelaxedByRays, 64,
         kRelaxed, true, statedBytes("relaxed", "none", "policarpo")},
    };
}

// Tables with hundreds of values a texel take hundreds of times as long as one.
int largestSizeOf(const preprocess::MapKind& kind, const preprocess::ReliefPlan& plan) {
    constexpr std::size_t kManyChannels = 64;
    return kind.channels(plan).size() > kManyChannels ? 64 : 512;
}

// A map of `relievo-bake relief` with its usual options.
BakeBuilder mapBuilder(const preprocess::MapKind& kind) {
    preprocess::ReliefPlan plan;
    plan.maps = {std::string(kind.name)};
    const auto build = [&kind, plan](const BakeInput& input) {
        textures::MapSet maps;
        kind.build({input.map, plan, {}}, maps);
        return otherOutput(std::move(maps));
    };
    BakeBuilder builder{std::string(kind.name), std::string(kind.description), build,
                        largestSizeOf(kind, plan)};
    builder.statedBytes = kind.workingBytes(plan);
    return builder;
}

// All that `relievo-bake relief` makes when it is not told which maps, besides reading and writing.
BakeOutput buildUsualMaps(const BakeInput& input) {
    preprocess::ReliefPlan plan;
    plan.cone = preprocess::usualCone(plan);
    return otherOutput(preprocess::bakeRelief(input.map, plan));
}

std::vector<BakeBuilder> makeBuilders() {
    std::vector<BakeBuilder> builders = surfaceBuilders();
    for (BakeBuilder& builder : coneBuilders())
        builders.push_back(std::move(builder));
    for (const preprocess::MapKind& kind : preprocess::mapKinds())
        if (kind.name != "depth" && kind.name != "derivative" && kind.name != "normal" &&
            kind.name != "cone")
            builders.push_back(mapBuilder(kind));
    builders.push_back({"relief", "the usual maps of relievo-bake relief", buildUsualMaps, 2048});
    return builders;
}

float medianOf(const textures::Plane& depth) {
    std::vector<float> depths = depth.texels;
    const auto median = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), median, depths.end());
    return *median;
}

std::vector<std::uint8_t> texelsAboveMedian(const textures::Plane& depth) {
    std::vector<std::uint8_t> raised(depth.texels.size());
    std::transform(depth.texels.begin(), depth.texels.end(), raised.begin(),
                   [limit = medianOf(depth)](float value) {
                       return value < limit ? std::uint8_t{1} : std::uint8_t{0};
                   });
    return raised;
}

// Whole texels but for those where the relief is within a hundredth of its median.
textures::Plane coverageAboveMedian(const textures::Plane& depth) {
    textures::Plane coverage = depth;
    const float median = medianOf(depth);
    for (float& value : coverage.texels)
        value = std::clamp(0.5f + 50.0f * (median - value), 0.0f, 1.0f);
    return coverage;
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
    input.shape = {coverageAboveMedian(input.map.depth), input.map.width(), input.map.height(), ""};
    return input;
}

std::span<const BakeBuilder> bakeBuilders() {
    static const std::vector<BakeBuilder> builders = makeBuilders();
    return builders;
}

const BakeBuilder& bakeBuilder(std::string_view name) {
    const auto found = std::ranges::find(bakeBuilders(), name, &BakeBuilder::name);
    if (found == bakeBuilders().end())
        throw std::invalid_argument("no map builder is called " + std::string(name));
    return *found;
}

}  // namespace relievo::bench
