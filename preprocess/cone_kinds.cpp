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

std::vector<std::string> surfaceConeChannels(const ReliefPlan&) {
    return {"cone"};
}

// Cones whose apex lies on the surface, from ratios: the channel `cone`.
void addSurfaceCones(const MapRequest& request, Plane ratio, MapSet& maps) {
    encodeConesInPlace(ratio, request.relief.depth, coneEncoding(request.plan));
    maps.channels.push_back({"cone", std::move(ratio)});
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

// "roof" of the only layer, "roof0" of the first of several.
std::string layerName(std::string_view channel, int layer, int sectors) {
    return sectors == 1 ? std::string(channel) : fmt::format("{}{}", channel, layer);
}

std::vector<std::string> roofConeChannels(const ReliefPlan& plan) {
    std::vector<std::string> names;
    for (int layer = 0; layer < plan.sectors; ++layer) {
        names.push_back(layerName("roof", layer, plan.sectors));
        names.push_back(layerName("ratio", layer, plan.sectors));
    }
    return names;
}

std::string buildRoofs(const MapRequest& request, MapSet& maps) {
    const int sectors = request.plan.sectors;
    const RoofConeRules rules{.sectors = sectors};
    // The layers together are the work that the caller knows as the texels of one map.
    const std::size_t texels = request.relief.depth.texels.size();
    StepProgress progress(request.advance, texels, texels * static_cast<std::size_t>(sectors));
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
    SlopeSearchStatistics work;
    addSurfaceCones(request, buildRelaxedCones(request.relief, kGuarantee, request.advance, &work),
                    maps);
    return countsOf(work, request);
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

constexpr ConeKind kKinds[] = {
    {"conservative", "bilinear", "exact", true, 28.0, surfaceConeChannels,
     buildConservative<ConeGuarantee::Bilinear>},
    {"conservative", "texel", "exact", true, 16.0, surfaceConeChannels,
     buildConservative<ConeGuarantee::Texel>},
    {"roof", "bilinear", "exact", false, 20.0, roofConeChannels, buildRoofs},
    {"conservative", "texel", "levels", true, 16.0, surfaceConeChannels, buildByLevels},
    {"conservative", "texel", "squares", true, 4.0, surfaceConeChannels, buildBySquares},
    {"conservative", "texel", "quick", true, 8.0, surfaceConeChannels, buildQuick},
    {"relaxed", "bilinear", "exact", true, 24.0, surfaceConeChannels,
     buildRelaxed<ConeGuarantee::Bilinear>},
    {"relaxed", "texel", "exact", true, 24.0, surfaceConeChannels,
     buildRelaxed<ConeGuarantee::Texel>},
    // As their authors left them: verify finds rays that pierce the relief twice.
    {"relaxed", "none", "maxima", true, 16.0, surfaceConeChannels, buildByMaxima},
    {"relaxed", "none", "policarpo", true, 4.0, surfaceConeChannels, buildByRays},
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
