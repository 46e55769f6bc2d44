#include "preprocess/relief_baker.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "preprocess/cone_kinds.h"
#include "preprocess/map_kinds.h"
#include "preprocess/mip_levels.h"
#include "textures/storage_format.h"
#include "textures/version.h"

namespace relievo::preprocess {
namespace {

constexpr std::size_t kPackedChannels = 4;

std::string problemOfMaps(const ReliefPlan& plan) {
    std::vector<std::string_view> known;
    for (const MapKind& kind : mapKinds())
        known.push_back(kind.name);
    for (const std::string& map : plan.maps)
        if (findMapKind(map) == nullptr)
            return fmt::format("--maps: '{}' is no map, expected some of {}", map,
                               fmt::join(known, ", "));
    return plan.maps.empty() ? fmt::format("--maps: expected some of {}", fmt::join(known, ", "))
                             : "";
}

std::string problemOfWords(const ReliefPlan& plan) {
    std::vector<std::string> offered;
    for (const ConeKind& kind : coneKinds())
        if (kind.cone == plan.cone)
            offered.push_back(
                fmt::format("--method {} --guarantee {}", kind.method, kind.guarantee));
    const auto asked = [](const char* option, const std::string& word) {
        return word.empty() ? "" : fmt::format(" --{} {}", option, word);
    };
    return fmt::format("--cone {}{}{}: not available, expected {}", plan.cone,
                       asked("method", plan.method), asked("guarantee", plan.guarantee),
                       fmt::join(offered, ", or "));
}

std::string problemOfEncoding(const ReliefPlan& plan, const ConeKind& kind) {
    const textures::ConeEncoding encoding = coneEncoding(plan);
    // A radius alone says nothing: the search divides it by the depth.
    if (encoding == textures::ConeEncoding::Radius && !plan.has("depth"))
        return "--maps: cones as radii need the map depth beside them";
    if (encoding == textures::ConeEncoding::Radius && kind.guarantee == "bilinear" &&
        kind.isOnSurface)
        return "--encode radius: says nothing over depth 0, where cones that are safe on the "
               "bilinear surface have a limit: expected ratio or sqrt, or --guarantee texel";
    if (encoding == textures::ConeEncoding::Radius && !kind.isOnSurface)
        return fmt::format("--encode radius: {} cones have none, expected ratio or sqrt",
                           kind.cone);
    if (encoding == textures::ConeEncoding::Sqrt && !textures::isPackedFormat(plan.format))
        return "--encode sqrt: serves the formats u16 and u8, expected ratio or radius for .exr";
    return "";
}

std::string problemOfSectors(const ReliefPlan& plan, const ConeKind& kind) {
    if (!plan.sectors || std::ranges::find(kind.sectors, *plan.sectors) != kind.sectors.end())
        return "";
    return fmt::format("--sectors {}: --cone {} --method {} --guarantee {} has {}", *plan.sectors,
                       kind.cone, kind.method, kind.guarantee, fmt::join(kind.sectors, " or "));
}

std::string problemOfCones(const ReliefPlan& plan) {
    if (!plan.has("cone"))
        return "";
    const ConeKind* const kind = findConeKind(plan);
    if (kind == nullptr)
        return problemOfWords(plan);
    const std::string problem = problemOfSectors(plan, *kind);
    return problem.empty() ? problemOfEncoding(plan, *kind) : problem;
}

std::string problemOfChannels(const ReliefPlan& plan) {
    const std::size_t channels = channelCount(plan);
    return textures::isPackedFormat(plan.format) && channels > kPackedChannels
               ? fmt::format(
                     "--maps asks for {} channels, but a PNG or TIFF holds {}: bake to .exr, or "
                     "fewer maps",
                     channels, kPackedChannels)
               : "";
}

std::string problemOfViews(const ReliefPlan& plan) {
    const ViewGrid& views = plan.views;
    if (views.azimuths < kFewestAzimuths || views.azimuths > kMostAzimuths)
        return fmt::format("--vdm-azimuths: expected {} to {}", kFewestAzimuths, kMostAzimuths);
    if (views.elevations < 1 || views.elevations > kMostElevations)
        return fmt::format("--vdm-elevations: expected 1 to {}", kMostElevations);
    if (views.curvatures < 1 || views.curvatures > kMostCurvatures || views.curvatures % 2 == 0)
        return fmt::format("--vdm-curvatures: expected an odd number from 1 to {}",
                           kMostCurvatures);
    if (views.views() > kMostViews)
        return fmt::format("--maps vdm: has {} views, expected at most {}", views.views(),
                           kMostViews);
    if (!(views.sharpest >= 0.0 && views.sharpest <= kLargestSharpest))
        return fmt::format("--vdm-range: expected a number from 0 to {}", kLargestSharpest);
    if (!(views.depthScale > 0.0 && views.depthScale <= kLargestViewScale))
        return fmt::format("--vdm-scale: expected a number above 0, up to {}", kLargestViewScale);
    if (plan.terms < 0 || plan.terms > kMostTerms)
        return fmt::format("--vdm-terms: expected 0 to {}", kMostTerms);
    if (plan.has("vdm") && plan.mips && plan.terms > 0)
        return "--mips: the map vdm has MIP levels with --vdm-terms 0 only, since each level would "
               "need weights of its own";
    if (plan.has("vdm") && textures::isPackedFormat(plan.format))
        return "--maps: the map vdm goes into .exr files only";
    return "";
}

}  // namespace

std::string planProblem(const ReliefPlan& plan) {
    for (const auto check : {problemOfMaps, problemOfCones, problemOfViews, problemOfChannels})
        if (std::string problem = check(plan); !problem.empty())
            return problem;
    if (!(plan.normalScale >= 0.0) || !std::isfinite(plan.normalScale))
        return "--normal-scale: expected a number from 0";
    if (plan.reach < 0 || plan.reach > kFarthestReach)
        return fmt::format("--reach: expected 0 to {}", kFarthestReach);
    if (!(plan.cylinderTolerance >= 0.0 && plan.cylinderTolerance <= 1.0))
        return "--cylinder-tolerance: expected a depth from 0 to 1";
    if (plan.azimuths < kFewestAzimuths || plan.azimuths > kMostAzimuths)
        return fmt::format("--azimuths: expected {} to {}", kFewestAzimuths, kMostAzimuths);
    if (plan.slices < 1 || plan.slices > kMostSlices)
        return fmt::format("--slices: expected 1 to {}", kMostSlices);
    if (!(plan.volumeScale > 0.0) || !std::isfinite(plan.volumeScale))
        return "--volume-scale: expected a number above 0";
    return "";
}

std::string optionWords(const ReliefPlan& plan) {
    std::vector<std::string_view> maps;
    for (const MapKind& kind : mapKinds())
        if (plan.has(kind.name))
            maps.push_back(kind.name);
    std::string words = fmt::format("maps={} format={}", fmt::join(maps, ","),
                                    textures::storageFormatName(plan.format));
    if (const ConeKind* const cones = plan.has("cone") ? findConeKind(plan) : nullptr) {
        words +=
            fmt::format(" cone={} guarantee={} method={} encode={}", cones->cone, cones->guarantee,
                        cones->method, textures::coneEncodingName(coneEncoding(plan)));
        if (cones->sectors.size() > 1)
            words += fmt::format(" sectors={}", coneSectors(plan));
    }
    if (plan.has("extrema"))
        words += fmt::format(" reach={}", plan.reach);
    if (plan.has("cylinder"))
        words += fmt::format(" cylinder-tolerance={}", plan.cylinderTolerance);
    if (plan.has("horizon") || plan.has("occlusion") || plan.has("ellipse"))
        words += fmt::format(" azimuths={}", plan.azimuths);
    if (plan.has("normal") || plan.has("occlusion") || plan.has("ellipse"))
        words += fmt::format(" normal-scale={}", plan.normalScale);
    if (plan.has("volume"))
        words += fmt::format(" slices={} volume-scale={}", plan.slices, plan.volumeScale);
    if (plan.has("vdm"))
        words += fmt::format(" vdm={}x{}x{} vdm-range={} vdm-scale={} vdm-terms={}",
                             plan.views.azimuths, plan.views.elevations, plan.views.curvatures,
                             plan.views.sharpest, plan.views.depthScale, plan.terms);
    return words + (plan.mips ? " mips" : "");
}

std::vector<textures::MapSet> bakeLevels(textures::DepthMap relief, const ReliefPlan& plan,
                                         const BakeObserver& observer) {
    std::vector<textures::MapSet> maps;
    if (!plan.mips) {
        maps.push_back(bakeRelief(std::move(relief), plan, observer));
        return maps;
    }
    std::vector<textures::DepthMap> levels = reliefLevels(std::move(relief));
    for (textures::DepthMap& level : levels)
        maps.push_back(
            bakeRelief(std::move(level), plan, maps.empty() ? observer : BakeObserver{}));
    return maps;
}

textures::MapSet bakeRelief(textures::DepthMap relief, const ReliefPlan& plan,
                            const BakeObserver& observer) {
    if (const std::string problem = planProblem(plan); !problem.empty())
        throw std::invalid_argument(problem);
    textures::storeInPlace(relief.depth, "depth", plan.format);
    textures::MapSet maps;
    maps.wrap = relief.wrap;
    maps.texelAspect = relief.texelAspect;
    maps.version = textures::kVersion;
    maps.attributes["relievo:options"] = optionWords(plan);
    for (const MapKind& kind : mapKinds()) {
        if (kind.build == nullptr || !plan.has(kind.name))
            continue;
        if (observer.begin)
            observer.begin(kind.name, relief.depth.texels.size());
        const std::string counts = kind.build({relief, plan, observer.advance}, maps);
        if (observer.end)
            observer.end(kind.name, counts);
    }
    if (plan.has("depth"))
        maps.channels.push_back({"depth", std::move(relief.depth)});
    return maps;
}

}  // namespace relievo::preprocess
