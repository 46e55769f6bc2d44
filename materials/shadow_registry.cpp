#include "materials/shadow_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "textures/input_error.h"

namespace relievo::materials {
namespace {

constexpr std::string_view kDepthMaps[] = {"depth"};
constexpr std::string_view kHorizonMaps[] = {"depth", "horizon"};
constexpr std::string_view kEllipseMaps[] = {"depth", "ellipse"};

constexpr TechniqueParameter kSoftParameters[] = {
    {"shadow-slices", "relievoShadowSlices",
     "slices of the light, side by side, before which the relief may stand at different heights", 1,
     16, 4, true, true},
    {"shadow-halvings", "relievoShadowHalvings",
     "searches that a slice takes in a penumbra besides those along its edges", 0, 16, 3, true,
     false},
};

constexpr ShadowMethod kMethods[] = {
    {.name = "search",
     .title = "hard shadows by search",
     .origin = "Policarpo, Oliveira, Comba 2005",
     .file = "relievo/shadows/search.glsl",
     .maps = kDepthMaps,
     .parameters = {},
     .searches = true,
     .errors = {{0.05, 16.3}, {0.05, 34.3}}},
    {.name = "soft",
     .title = "soft shadows by search",
     .origin = "Tatarchuk 2006; bisected, in slices: ours",
     .file = "relievo/shadows/soft.glsl",
     .maps = kDepthMaps,
     .parameters = kSoftParameters,
     .searches = true,
     .isSoft = true,
     .errors = {{0.05, 0.053}, {0.05, 0.49}}},
    {.name = "horizon",
     .title = "shadows by a horizon map",
     .origin = "Max 1988",
     .file = "relievo/shadows/horizon.glsl",
     .maps = kHorizonMaps,
     .parameters = {},
     .isSoft = true,
     .errors = {{10.6, 24.0}, {15.1, 30.6}}},
    {.name = "ellipse",
     .title = "shadows by visibility ellipses",
     .origin = "Heidrich, Daubert, Kautz, Seidel 2000",
     .file = "relievo/shadows/ellipse.glsl",
     .maps = kEllipseMaps,
     .parameters = {},
     .isSoft = true,
     .errors = {{22.3, 33.4}, {22.6, 43.7}}},
};

constexpr ShadowMethod kGiven = {.name = "reference",
                                 .title = "exact shadows",
                                 .origin = "double precision, on the CPU",
                                 .file = "relievo/shadows/given.glsl",
                                 .maps = kDepthMaps,
                                 .parameters = {},
                                 .isSoft = true};

}  // namespace

std::span<const ShadowMethod> shadowMethods() {
    return kMethods;
}

const ShadowMethod& givenShadowMethod() {
    return kGiven;
}

const ShadowMethod& findShadowMethod(std::string_view name) {
    const auto found = std::ranges::find(shadowMethods(), name, &ShadowMethod::name);
    if (found != shadowMethods().end())
        return *found;
    std::vector<std::string_view> names;
    for (const ShadowMethod& method : shadowMethods())
        names.push_back(method.name);
    throw textures::InputError(fmt::format("unknown shadow method \"{}\", expected one of {}", name,
                                           fmt::join(names, ", ")));
}

const TechniqueParameter* budgetParameter(const ShadowMethod& method) {
    const auto found = std::ranges::find_if(method.parameters, &TechniqueParameter::isBudget);
    return found == method.parameters.end() ? nullptr : &*found;
}

}  // namespace relievo::materials
