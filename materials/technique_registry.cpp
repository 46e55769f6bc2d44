#include "materials/technique_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "textures/input_error.h"

namespace relievo::materials {
namespace {

constexpr std::string_view kDepthMaps[] = {"depth"};
constexpr std::string_view kConeMaps[] = {"depth", "cone"};

constexpr TechniqueParameter kLinearParameters[] = {
    {"linear-steps", "relievoLinearSteps", "equal steps along the ray", 1, 4096, 64, true, true},
};
constexpr TechniqueParameter kReliefParameters[] = {
    {"linear-steps", "relievoLinearSteps", "equal steps along the ray", 1, 4096, 32, true, true},
    {"binary-steps", "relievoBinarySteps", "halvings of the step that pierced the surface", 0, 32,
     5, true, false},
};
constexpr TechniqueParameter kConeParameters[] = {
    {"cone-steps", "relievoConeSteps", "cones that a ray may cross before the search gives up", 1,
     16384, 2048, true, true},
    {"tolerance", "relievoTolerance", "depth above the surface that counts as a hit, of 1", 1e-7,
     0.1, 1.0 / 65536, false, false},
    {"refinements", "relievoConeRefinements", "halvings of a step that pierced the surface", 0, 32,
     10, true, false},
};

constexpr Technique kTechniques[] = {
    {"normal", "normal mapping", "Blinn 1978", "relievo/techniques/normal.glsl", kDepthMaps, {}},
    {"linear", "linear search", "thesis 2.3.1", "relievo/techniques/linear.glsl", kDepthMaps,
     kLinearParameters},
    {"relief", "relief mapping", "Policarpo, Oliveira, Comba 2005",
     "relievo/techniques/relief.glsl", kDepthMaps, kReliefParameters},
    {"cone", "cone tracing", "Dummer 2006", "relievo/techniques/cone.glsl", kConeMaps,
     kConeParameters},
};

constexpr Technique kGivenHits = {"reference",
                                  "exact reference",
                                  "double precision, on the CPU",
                                  "relievo/techniques/given.glsl",
                                  kDepthMaps,
                                  {}};

template <typename Entry>
std::string namesOf(std::span<const Entry> entries) {
    std::vector<std::string_view> names;
    for (const Entry& entry : entries)
        names.push_back(entry.name);
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::span<const Technique> techniques() {
    return kTechniques;
}

const Technique& givenHitsTechnique() {
    return kGivenHits;
}

const Technique& findTechnique(std::string_view name) {
    const auto found = std::ranges::find(techniques(), name, &Technique::name);
    if (found == techniques().end())
        throw textures::InputError(fmt::format("unknown technique \"{}\", expected one of {}", name,
                                               namesOf(techniques())));
    return *found;
}

const TechniqueParameter& findParameter(const Technique& technique, std::string_view name) {
    const auto found = std::ranges::find(technique.parameters, name, &TechniqueParameter::name);
    if (found == technique.parameters.end())
        throw textures::InputError(fmt::format("technique {} has no parameter \"{}\", it has {}",
                                               technique.name, name,
                                               namesOf(technique.parameters)));
    return *found;
}

const TechniqueParameter* budgetParameter(const Technique& technique) {
    const auto found = std::ranges::find_if(technique.parameters, &TechniqueParameter::isBudget);
    return found == technique.parameters.end() ? nullptr : &*found;
}

}  // namespace relievo::materials
