#include "materials/technique_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "textures/input_error.h"

namespace relievo::materials {
namespace {

constexpr std::string_view kDepthMaps[] = {"depth"};
constexpr std::string_view kSlopeMaps[] = {"depth", "derivative"};
constexpr std::string_view kConeMaps[] = {"depth", "cone"};
constexpr std::string_view kRelaxedMaps[] = {"depth", "relaxed-cone"};
constexpr std::string_view kVolumeMaps[] = {"depth", "volume"};
constexpr std::string_view kExtremaMaps[] = {"depth", "extrema"};
constexpr std::string_view kCylinderMaps[] = {"depth", "cylinder"};
constexpr std::string_view kPyramidMaps[] = {"depth", "pyramid"};
constexpr std::string_view kRoofMaps[] = {"depth", "roof"};

// Parameters that several techniques take.
constexpr TechniqueParameter linearSteps(int defaultValue) {
    return {"linear-steps",
            "relievoLinearSteps",
            "equal steps along the ray",
            1,
            4096,
            static_cast<double>(defaultValue),
            true,
            true};
}
constexpr TechniqueParameter binarySteps(int defaultValue, bool isBudget = false) {
    return {"binary-steps",
            "relievoBinarySteps",
            "halvings of the stretch that holds a crossing",
            0,
            32,
            static_cast<double>(defaultValue),
            true,
            isBudget};
}
constexpr TechniqueParameter secantSteps(int defaultValue, bool isBudget = false) {
    return {"secant-steps",
            "relievoSecantSteps",
            "crossings of the line through both ends of that stretch",
            0,
            32,
            static_cast<double>(defaultValue),
            true,
            isBudget};
}
constexpr TechniqueParameter kConeSteps = {"cone-steps",
                                           "relievoConeSteps",
                                           "cones that a ray may cross before the search gives up",
                                           1,
                                           16384,
                                           2048,
                                           true,
                                           true};
constexpr TechniqueParameter kTolerance = {"tolerance",
                                           "relievoTolerance",
                                           "depth above the surface that counts as a hit, of 1",
                                           1e-7,
                                           0.1,
                                           1.0 / 65536,
                                           false,
                                           false};

constexpr TechniqueParameter kParallaxParameters[] = {
    {"parallax-steps", "relievoParallaxSteps",
     "approximations, one of which is slope-aware "
     "parallax mapping",
     1, 256, 4, true, true},
};
constexpr TechniqueParameter kBinaryParameters[] = {binarySteps(8, true)};
constexpr TechniqueParameter kSecantParameters[] = {secantSteps(8, true)};
constexpr TechniqueParameter kLinearParameters[] = {linearSteps(64)};
constexpr TechniqueParameter kReliefParameters[] = {linearSteps(32), binarySteps(5)};
constexpr TechniqueParameter kIntervalParameters[] = {linearSteps(32), secantSteps(3)};
constexpr TechniqueParameter kOcclusionParameters[] = {
    {"most-steps", "relievoMostSteps", "equal steps along rays that graze the surface", 1, 4096, 64,
     true, true},
    {"fewest-steps", "relievoFewestSteps", "equal steps along rays from straight above", 1, 4096, 8,
     true, false},
};
constexpr TechniqueParameter kConeParameters[] = {
    kConeSteps,
    kTolerance,
    {"refinements", "relievoConeRefinements", "halvings of a step that pierced the surface", 0, 32,
     10, true, false},
};
constexpr TechniqueParameter kRelaxedParameters[] = {kConeSteps, kTolerance, binarySteps(10)};
constexpr TechniqueParameter kRelaxedSecantParameters[] = {kConeSteps, kTolerance, secantSteps(5)};
constexpr TechniqueParameter kSkipParameters[] = {
    {"skip-steps", "relievoSkipSteps", "steps that a ray may take before it gives up", 1, 65536,
     4096, true, true},
    {"least-step", "relievoLeastStep", "texels that a ray goes where the map gives it nothing",
     0.01, 16, 0.5, false, false},
    binarySteps(10),
};
constexpr TechniqueParameter kPyramidParameters[] = {
    {"pyramid-steps", "relievoPyramidSteps", "nodes that a ray may visit before it gives up", 1,
     65536, 16384, true, true},
};
constexpr TechniqueParameter kExactParameters[] = {
    {"exact-steps", "relievoExactSteps", "cones and cells that a ray may cross before it gives up",
     1, 65536, 16384, true, true},
};

constexpr Technique kTechniques[] = {
    {"normal", "normal mapping", "Blinn 1978", "relievo/techniques/normal.glsl", kDepthMaps, {}},
    {"parallax",
     "parallax mapping",
     "Kaneko et al. 2001",
     "relievo/techniques/parallax.glsl",
     kDepthMaps,
     {}},
    {"offset-limited",
     "parallax with offset limiting",
     "Welsh 2004",
     "relievo/techniques/offset_limited.glsl",
     kDepthMaps,
     {}},
    {"iterative-parallax", "iterative parallax mapping", "Premecz 2006",
     "relievo/techniques/iterative_parallax.glsl", kSlopeMaps, kParallaxParameters},
    {"binary", "binary search", "thesis 2.3.2", "relievo/techniques/binary.glsl", kDepthMaps,
     kBinaryParameters},
    {"secant", "secant search", "thesis 2.3.2", "relievo/techniques/secant.glsl", kDepthMaps,
     kSecantParameters},
    {"linear", "linear search", "thesis 2.3.1", "relievo/techniques/linear.glsl", kDepthMaps,
     kLinearParameters},
    {"parallax-occlusion", "parallax occlusion mapping", "Tatarchuk 2006",
     "relievo/techniques/parallax_occlusion.glsl", kDepthMaps, kOcclusionParameters},
    {"relief", "relief mapping", "Policarpo, Oliveira, Comba 2005",
     "relievo/techniques/relief.glsl", kDepthMaps, kReliefParameters},
    {"interval", "interval mapping", "Risser, Shah, Pattanaik 2006",
     "relievo/techniques/interval.glsl", kDepthMaps, kIntervalParameters},
    {"sphere", "sphere tracing", "Donnelly 2005", "relievo/techniques/sphere.glsl", kVolumeMaps,
     kSkipParameters},
    {"safety-zones", "dilation and erosion", "Kolb, Rezk-Salama 2005",
     "relievo/techniques/safety_zones.glsl", kExtremaMaps, kSkipParameters},
    {"cylinder", "cylinder tracing", "Baboud, Décoret 2006", "relievo/techniques/cylinder.glsl",
     kCylinderMaps, kSkipParameters},
    {"cone", "cone tracing", "Dummer 2006", "relievo/techniques/cone.glsl", kConeMaps,
     kConeParameters},
    {"relaxed", "relaxed cones and binary search", "Policarpo, Oliveira 2007",
     "relievo/techniques/relaxed.glsl", kRelaxedMaps, kRelaxedParameters},
    {"relaxed-secant", "relaxed cones and secant search", "Policarpo, Oliveira 2007",
     "relievo/techniques/relaxed_secant.glsl", kRelaxedMaps, kRelaxedSecantParameters},
    {"pyramid", "exact hits by a depth pyramid", "Oh, Ki, Lee 2006; Tevs, Ihrke, Seidel 2008",
     "relievo/techniques/pyramid.glsl", kPyramidMaps, kPyramidParameters},
    {"exact", "exact hits by roof cones", "ours", "relievo/techniques/exact.glsl", kRoofMaps,
     kExactParameters},
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
