#include "preprocess/map_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "preprocess/cone_kinds.h"
#include "preprocess/derivatives.h"
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
