#include "preprocess/cone_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "preprocess/cone_encoding.h"
#include "preprocess/cones_by_levels.h"
#include "preprocess/cones_by_squares.h"
#include "preprocess/conservative_cones.h"
#include "preprocess/quick_cones.h"
#include "preprocess/relaxed_cones.h"
#include "preprocess/relaxed_cones_by_maxima.h"
#include "preprocess/relaxed_cones_policarpo.h"
#include "preprocess/roof_cones.h"
#include "preprocess/step_progress.h"

namespace relievo::preprocess {
namespace {

using textures::MapSet;
using textures::Plane;

constexpr int kLevels = 256;  // of the thesis, which knows 8-bit depths

// "cone" of the only layer, "cone0" of the first of several.
std::string layerName(std::string_view channel, int layer, int sectors) {
    return sectors == 1 ? std::string(channel) : fmt::format("{}{}", channel, layer);
}

std::vector<std::string> surfaceConeChannels(const ReliefPlan& plan) {
    const int sectors = coneSectors(plan);
    std::vector<std::string> names;
    for (int layer = 0; layer < sectors; ++layer)
        names.push_back(layerName("cone", layer, sectors));
    return names;
}

// Cones whose apex lies on the surface, from ratios: the channel `cone`, or one for each sector.
void addSurfaceCones(const MapRequest& request, std::vector<Plane> ratios, MapSet& maps) {
    const int sectors = static_cast<int>(ratios.size());
    for (int layer = 0; layer < sectors; ++layer) {
        Plane& ratio = ratios[static_cast<std::size_t>(layer)];
        encodeConesInPlace(ratio, request.relief.depth, coneEncoding(request.plan));
        maps.channels.push_back({layerName("cone", layer, sectors), std::move(ratio)});
    }
}
void addSurfaceCones(const MapRequest& request, Plane ratio, MapSet& maps) {
    std::vector<Plane> only;
    only.push_back(std::move(ratio));
    addSurfaceCones(request, std::move(only), maps);
}

std::string countsOf(const SlopeSearchStatistics& work, const MapRequest& request) {
    const auto texels = static_cast<double>(request.relief.depth.texels.size());
    return fmt::format("{:.1f} nodes and {:.1f} texels visited for each",
                       static_cast<double>(work.nodes) / texels,
                       static_cast<double>(work.samples) / texels);
}

template <ConeGuarantee kGuarantee>
std::string buildConservative(const MapRequest& request, MapSet& maps) {
    SlopeSearchStatistics work;
    addSurfaceCones(
        request, buildConservativeCones(request.relief, kGuarantee, request.advance, &work), maps);
    return countsOf(work, request);
}

std::vector<std::string> roofConeChannels(const ReliefPlan& plan) {
    std::vector<std::string> names;
    const int sectors = coneSectors(plan);
    for (int layer = 0; layer < sectors; ++layer) {
        names.push_back(layerName("roof", layer, sectors));
        names.push_back(layerName("ratio", layer, sectors));
    }
    return names;
}

// The sectors together are the work that the caller knows as the texels of one map.
StepProgress progressOfSectors(const MapRequest& request, int sectors) {
    const std::size_t texels = request.relief.depth.texels.size();
    return {request.advance, texels, texels * static_cast<std::size_t>(sectors)};
}

std::string buildRoofs(const MapRequest& request, MapSet& maps) {
    const int sectors = coneSectors(request.plan);
    const RoofConeRules rules{.sectors = sectors};
    StepProgress progress = progressOfSectors(request, sectors);
    SlopeSearchStatistics work;
    std::vector<RoofConeLayer> layers = buildRoofCones(
        request.relief, rules, [&](std::size_t cells) { progress.done(cells); }, &work);
    for (int layer = 0; layer < sectors; ++layer) {
        RoofConeLayer& cones = layers[static_cast<std::size_t>(layer)];
        maps.channels.push_back({layerName("roof", layer, sectors), std::move(cones.roof)});
        maps.channels.push_back({layerName("ratio", layer, sectors), std::move(cones.ratio)});
    }
    maps.attributes["relievo:block"] = fmt::format("{}", rules.block);
    return fmt::format("{} sectors, {}", sectors, countsOf(work, request));
}

template <ConeGuarantee kGuarantee>
std::string buildRelaxed(const MapRequest& request, MapSet& maps) {
    const int sectors = coneSectors(request.plan);
    StepProgress progress = progressOfSectors(request, sectors);
    SlopeSearchStatistics work;
    addSurfaceCones(request,
                    buildRelaxedConeSectors(
                        request.relief, kGuarantee, sectors,
                        [&](std::size_t texels) { progress.done(texels); }, &work),
                    maps);
    const std::string counts = countsOf(work, request);
    return sectors == 1 ? counts : fmt::format("{} sectors, {}", sectors, counts);
}

std::string buildByLevels(const MapRequest& request, MapSet& maps) {
    addSurfaceCones(request, buildConesByLevels(request.relief, kLevels, request.advance), maps);
    return fmt::format("at most {} levels", kLevels);
}

std::string buildBySquares(const MapRequest& request, MapSet& maps) {
    addSurfaceCones(request, buildConesBySquares(request.relief, request.advance), maps);
    return "growing squares";
}

std::string buildQuick(const MapRequest& request, MapSet& maps) {
    addSurfaceCones(request, buildQuickCones(request.relief, request.advance), maps);
    return "a fixed walk up the pyramid";
}

std::string buildByMaxima(const MapRequest& request, MapSet& maps) {
    addSurfaceCones(request, buildRelaxedConesByMaxima(request.relief, kLevels, request.advance),
                    maps);
    return fmt::format("at most {} levels", kLevels);
}

std::string buildByRays(const MapRequest& request, MapSet& maps) {
    addSurfaceCones(request, buildRelaxedConesByRays(request.relief, request.advance), maps);
    return "rays between all texels";
}

constexpr int kAllDirections[] = {1};
constexpr int kRoofSectors[] = {4, 1, 8};
constexpr int kRelaxedSectors[] = {8, 1, 4};

constexpr ConeKind kKinds[] = {
    {"conservative", "bilinear", "exact", true, kAllDirections, 28.0, surfaceConeChannels,
     buildConservative<ConeGuarantee::Bilinear>},
    {"conservative", "texel", "exact", true, kAllDirections, 16.0, surfaceConeChannels,
     buildConservative<ConeGuarantee::Texel>},
    {"roof", "bilinear", "exact", false, kRoofSectors, 20.0, roofConeChannels, buildRoofs},
    {"conservative", "texel", "levels", true, kAllDirections, 16.0, surfaceConeChannels,
     buildByLevels},
    {"conservative", "texel", "squares", true, kAllDirections, 4.0, surfaceConeChannels,
     buildBySquares},
    {"conservative", "texel", "quick", true, kAllDirections, 8.0, surfaceConeChannels, buildQuick},
    {"relaxed", "bilinear", "exact", true, kRelaxedSectors, 24.0, surfaceConeChannels,
     buildRelaxed<ConeGuarantee::Bilinear>},
    {"relaxed", "texel", "exact", true, kAllDirections, 24.0, surfaceConeChannels,
     buildRelaxed<ConeGuarantee::Texel>},
    // As their authors left them: verify finds rays that pierce the relief twice.
    {"relaxed", "none", "maxima", true, kAllDirections, 16.0, surfaceConeChannels, buildByMaxima},
    {"relaxed", "none", "policarpo", true, kAllDirections, 4.0, surfaceConeChannels, buildByRays},
};

bool fits(const std::string& wanted, std::string_view word) {
    return wanted.empty() || wanted == word;
}

}  // namespace

std::span<const ConeKind> coneKinds() {
    return kKinds;
}

const ConeKind* findConeKind(const ReliefPlan& plan) {
    const auto found = std::ranges::find_if(kKinds, [&](const ConeKind& kind) {
        return plan.cone == kind.cone && fits(plan.guarantee, kind.guarantee) &&
               fits(plan.method, kind.method);
    });
    return found == std::end(kKinds) ? nullptr : &*found;
}

textures::ConeEncoding coneEncoding(const ReliefPlan& plan) {
    return plan.encoding.value_or(textures::ConeEncoding::Ratio);
}

int coneSectors(const ReliefPlan& plan) {
    const ConeKind& kind = *findConeKind(plan);
    const bool isCramped = kind.isOnSurface && textures::isPackedFormat(plan.format);
    return plan.sectors.value_or(isCramped ? 1 : kind.sectors.front());
}

std::string usualCone(ReliefPlan plan) {
    for (const char* const cone : {"roof", "conservative", "relaxed"}) {
        plan.cone = cone;
        const ConeKind* const kind = findConeKind(plan);
        if (kind != nullptr && (kind->isOnSurface || !textures::isPackedFormat(plan.format)))
            return cone;
    }
    return "conservative";
}

std::vector<std::string> coneWords(std::string_view ConeKind::*respect) {
    std::vector<std::string> words;
    for (const ConeKind& kind : kKinds)
        if (std::ranges::find(words, kind.*respect) == words.end())
            words.emplace_back(kind.*respect);
    return words;
}

}  // namespace relievo::preprocess
