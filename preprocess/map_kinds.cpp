#include "preprocess/map_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "preprocess/cone_kinds.h"
#include "preprocess/derivatives.h"
#include "preprocess/distance_volume.h"
#include "preprocess/normals.h"

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
    {"volume", "volume0, volume1 ...: distances in --slices layers at --volume-scale",
     volumeChannels, buildVolume, bytes<16>},
    {"normal", "nx, ny, nz: unit normals at --normal-scale", normalChannels, buildNormalMap,
     bytes<8>},
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

}  // namespace relievo::preprocess
