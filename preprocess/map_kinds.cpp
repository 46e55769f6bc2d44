#include "preprocess/map_kinds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "preprocess/ambient_occlusion.h"
#include "preprocess/cone_kinds.h"
#include "preprocess/cylinder_radii.h"
#include "preprocess/derivatives.h"
#include "preprocess/dilation_erosion.h"
#include "preprocess/displacement_error.h"
#include "preprocess/displacement_factors.h"
#include "preprocess/distance_volume.h"
#include "preprocess/horizon_map.h"
#include "preprocess/normals.h"
#include "preprocess/step_progress.h"
#include "preprocess/tolerant_radii.h"
#include "preprocess/view_displacement.h"
#include "preprocess/visibility_ellipses.h"

namespace relievo::preprocess {
namespace {

using textures::MapSet;

template <int kBytes>
double bytes(const ReliefPlan&) {
    return kBytes;
}

std::vector<std::string> depthChannels(const ReliefPlan&) {
    return {"depth"};
}

std::vector<std::string> coneChannels(const ReliefPlan& plan) {
    const ConeKind* const kind = findConeKind(plan);
    return kind != nullptr ? kind->channels(plan) : std::vector<std::string>{};
}

std::string buildCones(const MapRequest& request, MapSet& maps) {
    const ConeKind& kind = *findConeKind(request.plan);
    maps.attributes["relievo:cone"] = kind.cone;
    maps.attributes["relievo:guarantee"] = kind.guarantee;
    maps.attributes["relievo:method"] = kind.method;
    maps.encoding = coneEncoding(request.plan);
    return kind.build(request, maps);
}

double coneBytes(const ReliefPlan& plan) {
    const ConeKind* const kind = findConeKind(plan);
    return kind != nullptr ? kind->workingBytes : 0.0;
}

std::vector<std::string> numbered(std::string_view channel, int count) {
    std::vector<std::string> names;
    for (int k = 0; k < count; ++k)
        names.push_back(fmt::format("{}{}", channel, k));
    return names;
}

void addNumbered(std::string_view channel, std::vector<textures::Plane> planes, MapSet& maps) {
    for (std::size_t k = 0; k < planes.size(); ++k)
        maps.channels.push_back({fmt::format("{}{}", channel, k), std::move(planes[k])});
}

std::vector<std::string> volumeChannels(const ReliefPlan& plan) {
    return numbered("volume", plan.slices);
}

std::string buildVolume(const MapRequest& request, MapSet& maps) {
    const ReliefPlan& plan = request.plan;
    addNumbered("volume",
                buildDistanceVolume(request.relief, plan.slices, plan.volumeScale, request.advance),
                maps);
    maps.attributes["relievo:volume-scale"] = fmt::format("{}", plan.volumeScale);
    return fmt::format("{} slices at depth scale {}", plan.slices, plan.volumeScale);
}

std::vector<std::string> displacementChannels(const ReliefPlan& plan) {
    if (plan.terms == 0)
        return numbered("vdm", static_cast<int>(plan.views.views()));
    std::vector<std::string> names = numbered("vdmfactor", plan.terms * plan.views.azimuths);
    for (std::string& name : numbered("vdmmiss", static_cast<int>(missesPlanes(plan.views))))
        names.push_back(std::move(name));
    return names;
}

// Packing a table takes about this share of the time of its building and packing.
constexpr std::size_t kPackingShare = 4;

// The table itself while it is packed.
double displacementBytes(const ReliefPlan& plan) {
    return plan.terms == 0 ? 0.0 : sizeof(float) * static_cast<double>(plan.views.views());
}

std::string packDisplacements(std::vector<textures::Plane> table, const ReliefPlan& plan,
                              StepProgress& progress, MapSet& maps) {
    DisplacementFactors factors =
        factorDisplacement(table, plan.views, plan.terms, plan.format,
                           [&](std::size_t columns) { progress.done(columns); });
    const DisplacementError error = measureFactors(table, plan.views, factors);
    std::vector<std::string> weights;
    for (const std::vector<float>& term : factors.weights)
        weights.push_back(fmt::format("{}", fmt::join(term, " ")));
    maps.attributes["relievo:vdm-weights"] = fmt::format("{}", fmt::join(weights, " "));
    maps.attributes["relievo:vdm-error"] =
        fmt::format("{} {} {}", error.mean, error.percentile99, error.greatest);
    addNumbered("vdmfactor", std::move(factors.factors), maps);
    addNumbered("vdmmiss", std::move(factors.misses), maps);
    return fmt::format("{} views, off by {:.2g}, 99% {:.2g}, at most {:.2g}", plan.views.views(),
                       error.mean, error.percentile99, error.greatest);
}

std::string buildDisplacements(const MapRequest& request, MapSet& maps) {
    const ViewGrid& views = request.plan.views;
    maps.attributes["relievo:vdm-views"] =
        fmt::format("{} {} {}", views.azimuths, views.elevations, views.curvatures);
    maps.attributes["relievo:vdm-range"] = fmt::format("{}", views.sharpest);
    maps.attributes["relievo:vdm-scale"] = fmt::format("{}", views.depthScale);
    const bool isPacked = request.plan.terms > 0;
    const std::size_t texels = request.relief.depth.texels.size();
    const std::size_t packingTexels = isPacked ? texels / kPackingShare : 0;
    StepProgress building(request.advance, texels - packingTexels, texels);
    std::vector<textures::Plane> table = buildViewDisplacement(
        request.relief, views, [&](std::size_t done) { building.done(done); });
    if (isPacked) {
        StepProgress packing(request.advance, packingTexels,
                             factorSteps(views, request.plan.terms));
        return packDisplacements(std::move(table), request.plan, packing, maps);
    }
    addNumbered("vdm", std::move(table), maps);
    return fmt::format("{} views at depth scale {}", views.views(), views.depthScale);
}

std::vector<std::string> horizonChannels(const ReliefPlan& plan) {
    return numbered("horizon", plan.azimuths);
}

std::vector<textures::Plane> buildAllHorizons(const MapRequest& request) {
    StepProgress progress(request.advance, request.relief.depth.texels.size(),
                          static_cast<std::size_t>(request.plan.azimuths));
    std::vector<textures::Plane> horizons;
    for (int k = 0; k < request.plan.azimuths; ++k) {
        horizons.push_back(buildHorizon(request.relief, azimuthOf(k, request.plan.azimuths)));
        progress.done();
    }
    return horizons;
}

std::string buildHorizonMap(const MapRequest& request, MapSet& maps) {
    addNumbered("horizon", buildAllHorizons(request), maps);
    return fmt::format("{} azimuths", request.plan.azimuths);
}

// Calls use(horizons): those of the map `horizon`, if it is built already.
template <typename Use>
std::string useHorizons(const MapRequest& request, const MapSet& maps, const Use& use) {
    std::vector<textures::Plane> built;
    std::vector<const textures::Plane*> horizons;
    for (const std::string& name : horizonChannels(request.plan))
        if (const textures::Plane* const horizon = maps.find(name))
            horizons.push_back(horizon);
    if (horizons.empty()) {
        built = buildAllHorizons(request);
        for (const textures::Plane& horizon : built)
            horizons.push_back(&horizon);
    }
    use(horizons);
    return fmt::format("from {} azimuths at depth scale {}", horizons.size(),
                       request.plan.normalScale);
}

double horizonBytes(const ReliefPlan& plan) {
    return sizeof(float) * static_cast<double>(plan.has("horizon") ? 0 : plan.azimuths) + 8.0;
}

std::vector<std::string> occlusionChannels(const ReliefPlan&) {
    return {"occlusion"};
}

std::string buildOcclusionMap(const MapRequest& request, MapSet& maps) {
    textures::Plane occlusion;
    std::string counts = useHorizons(request, maps, [&](const auto& horizons) {
        occlusion = buildOcclusion(horizons, request.plan.normalScale);
    });
    maps.channels.push_back({"occlusion", std::move(occlusion)});
    maps.attributes["relievo:normal-scale"] = fmt::format("{}", request.plan.normalScale);
    return counts;
}

std::vector<std::string> ellipseChannels(const ReliefPlan&) {
    return {"ellipsex", "ellipsey", "ellipsea", "ellipseb", "ellipseangle"};
}

std::string buildEllipses(const MapRequest& request, MapSet& maps) {
    VisibilityEllipses ellipses;
    std::string counts = useHorizons(request, maps, [&](const auto& horizons) {
        ellipses = fitVisibilityEllipses(horizons, request.plan.normalScale);
    });
    maps.channels.push_back({"ellipsex", std::move(ellipses.centreX)});
    maps.channels.push_back({"ellipsey", std::move(ellipses.centreY)});
    maps.channels.push_back({"ellipsea", std::move(ellipses.longer)});
    maps.channels.push_back({"ellipseb", std::move(ellipses.shorter)});
    maps.channels.push_back({"ellipseangle", std::move(ellipses.angle)});
    maps.attributes["relievo:normal-scale"] = fmt::format("{}", request.plan.normalScale);
    return counts;
}

std::vector<std::string> cylinderChannels(const ReliefPlan&) {
    return {"cylinder"};
}

std::string buildCylinders(const MapRequest& request, MapSet& maps) {
    const double tolerance = request.plan.cylinderTolerance;
    textures::Plane radii = buildCylinderRadii(request.relief);
    if (tolerance > 0.0) {
        const textures::Plane tolerant = buildTolerantRadii(request.relief, tolerance);
        std::ranges::transform(radii.texels, tolerant.texels, radii.texels.begin(),
                               [](float a, float b) { return std::max(a, b); });
    }
    const auto stalling = std::ranges::count(radii.texels, 0.0f);
    maps.channels.push_back({"cylinder", std::move(radii)});
    maps.attributes["relievo:cylinder-tolerance"] = fmt::format("{}", tolerance);
    return fmt::format("tolerance {}, no radius at {} texels", tolerance, stalling);
}

std::vector<std::string> extremaChannels(const ReliefPlan&) {
    return {"dmin", "dmax"};
}

std::string buildExtrema(const MapRequest& request, MapSet& maps) {
    const int reach = request.plan.reach;
    DepthExtrema extrema = findDepthExtrema(request.relief, reach);
    maps.channels.push_back({"dmin", std::move(extrema.least)});
    maps.channels.push_back({"dmax", std::move(extrema.greatest)});
    maps.attributes["relievo:reach"] = fmt::format("{}", reach);
    return fmt::format("of {0} x {0} texels", 2 * reach + 1);
}

std::vector<std::string> normalChannels(const ReliefPlan&) {
    return {"nx", "ny", "nz"};
}

std::string buildNormalMap(const MapRequest& request, MapSet& maps) {
    const double scale = request.plan.normalScale;
    Normals normals = buildNormals(buildDerivatives(request.relief), scale);
    maps.channels.push_back({"nx", std::move(normals.nx)});
    maps.channels.push_back({"ny", std::move(normals.ny)});
    maps.channels.push_back({"nz", std::move(normals.nz)});
    maps.attributes["relievo:normal-scale"] = fmt::format("{}", scale);
    return fmt::format("nx, ny, nz at depth scale {}", scale);
}

std::vector<std::string> derivativeChannels(const ReliefPlan&) {
    return {"dx", "dy"};
}

std::string buildDerivativeMap(const MapRequest& request, MapSet& maps) {
    Derivatives derivatives = buildDerivatives(request.relief);
    maps.channels.push_back({"dx", std::move(derivatives.dx)});
    maps.channels.push_back({"dy", std::move(derivatives.dy)});
    return "dx, dy";
}

constexpr MapKind kKinds[] = {
    {"cone", "cones of the kind that --cone says", coneChannels, buildCones, coneBytes},
    {"vdm",
     "vdmfactor0 ... vdmmiss0 ..., or vdm0 ...: displacements along view rays over a curved base, "
     "in --vdm-terms products",
     displacementChannels, buildDisplacements, displacementBytes},
    {"volume", "volume0, volume1 ...: distances in --slices layers at --volume-scale",
     volumeChannels, buildVolume, bytes<16>},
    {"horizon", "horizon0, horizon1 ...: slopes to the horizon in --azimuths directions",
     horizonChannels, buildHorizonMap, bytes<8>},
    {"ellipse",
     "ellipsex, ellipsey, ellipsea, ellipseb, ellipseangle: what is seen of the sky at "
     "--normal-scale",
     ellipseChannels, buildEllipses, horizonBytes},
    {"occlusion", "occlusion: the share of the sky's light at --normal-scale", occlusionChannels,
     buildOcclusionMap, horizonBytes},
    {"cylinder",
     "cylinder: radii in which no ray pierces the relief twice, but for "
     "--cylinder-tolerance",
     cylinderChannels, buildCylinders, bytes<80>},
    {"normal", "nx, ny, nz: unit normals at --normal-scale", normalChannels, buildNormalMap,
     bytes<8>},
    {"extrema", "dmin, dmax: least and greatest depths within --reach texels", extremaChannels,
     buildExtrema, bytes<0>},
    {"derivative", "dx, dy: slopes", derivativeChannels, buildDerivativeMap, bytes<0>},
    {"depth", "depth: the relief itself", depthChannels, nullptr, bytes<0>},
};

}  // namespace

std::span<const MapKind> mapKinds() {
    return kKinds;
}

const MapKind* findMapKind(std::string_view name) {
    const auto found = std::ranges::find(kKinds, name, &MapKind::name);
    return found == std::end(kKinds) ? nullptr : &*found;
}

std::size_t channelCount(const ReliefPlan& plan) {
    std::size_t count = 0;
    for (const std::string& map : plan.maps)
        count += findMapKind(map)->channels(plan).size();
    return count;
}

}  // namespace relievo::preprocess
