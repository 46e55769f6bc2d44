#include "materials/technique_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "textures/input_error.h"

namespace relievo::materials {
namespace {

constexpr std::string_view kDepthMaps[] = {"depth"};
constexpr std::string_view kConeMaps[] = {"depth", "cone"};
constexpr std::string_view kRelaxedMaps[] = {"depth", "relaxed-cone"};
constexpr std::string_view kVolumeMaps[] = {"depth", "volume"};
constexpr std::string_view kExtremaMaps[] = {"depth", "extrema"};
constexpr std::string_view kCylinderMaps[] = {"depth", "cylinder"};
constexpr std::string_view kPyramidMaps[] = {"depth", "pyramid"};
constexpr std::string_view kDisplacementMaps[] = {"depth", "vdm", "vdm-weights"};
constexpr std::string_view kRoofMaps[] = {"depth", "roof"};

// Parameters that several techniques take.
constexpr TechniqueParameter linearSteps(int defaultValue) {
    return {"linear-steps",
            "relievoLinearSteps",
            "equal steps along the ray",
            1,
            65536,
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
    {"parallax-steps", "relievoParallaxSteps", "approximations, each from the last one", 1, 256, 4,
     true, true},
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
constexpr TechniqueParameter kConeStepParameters[] = {kConeSteps, kTolerance, binarySteps(10)};
constexpr TechniqueParameter kConeParameters[] = {kConeSteps, binarySteps(10)};
constexpr TechniqueParameter kRelaxedSecantParameters[] = {kConeSteps, secantSteps(16)};
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
constexpr TechniqueParameter kExactSteps = {
    "exact-steps",
    "relievoExactSteps",
    "cones and cells that a ray may cross before it gives up",
    1,
    65536,
    16384,
    true,
    true};
constexpr TechniqueParameter kExactParameters[] = {kExactSteps};
constexpr TechniqueParameter kAutoParameters[] = {
    kExactSteps,
    {"pixel-error", "relievoPixelError", "pixels by which a point may be out of place", 0.001, 64,
     0.25, false, false},
};

constexpr Technique kTechniques[] = {
    {.name = "normal",
     .title = "normal mapping",
     .origin = "Blinn 1978",
     .file = "relievo/techniques/normal.glsl",
     .maps = kDepthMaps,
     .parameters = {},
     .errors = {{100.0, 17.8}, {100.0, 45.9}},
     .isSearch = false},
    {.name = "parallax",
     .title = "parallax mapping",
     .origin = "Kaneko et al. 2001",
     .file = "relievo/techniques/parallax.glsl",
     .maps = kDepthMaps,
     .parameters = {},
     .errors = {{89.7, 5.46}, {100.0, 21.6}},
     .isSearch = false},
    {.name = "offset-limited",
     .title = "parallax with offset limiting",
     .origin = "Welsh 2004",
     .file = "relievo/techniques/offset_limited.glsl",
     .maps = kDepthMaps,
     .parameters = {},
     .errors = {{100.0, 5.38}, {100.0, 33.3}},
     .isSearch = false},
    {.name = "slope-aware",
     .title = "slope-aware parallax mapping",
     .origin = "Premecz 2006",
     .file = "relievo/techniques/slope_aware.glsl",
     .maps = kDepthMaps,
     .parameters = {},
     .errors = {{100.0, 6.1}, {100.0, 33.5}},
     .isSearch = false},
    {.name = "iterative-parallax",
     .title = "iterative parallax mapping",
     .origin = "Premecz 2006",
     .file = "relievo/techniques/iterative_parallax.glsl",
     .maps = kDepthMaps,
     .parameters = kParallaxParameters,
     .errors = {{36.7, 2.37}, {100.0, 14.2}},
     .isSearch = false},
    {.name = "vdm",
     .title = "view-dependent displacement mapping",
     .origin = "Wang et al. 2003",
     .file = "relievo/techniques/vdm.glsl",
     .maps = kDisplacementMaps,
     .parameters = {},
     .errors = {{36.0, 1.33}, {94.8, 6.4}},
     .isSearch = false},
    {.name = "binary",
     .title = "binary search",
     .origin = "thesis 2.3.2",
     .file = "relievo/techniques/binary.glsl",
     .maps = kDepthMaps,
     .parameters = kBinaryParameters,
     .errors = {{26.5, 2.73}, {79.4, 17.2}}},
    {.name = "secant",
     .title = "secant search",
     .origin = "thesis 2.3.2",
     .file = "relievo/techniques/secant.glsl",
     .maps = kDepthMaps,
     .parameters = kSecantParameters,
     .errors = {{32.7, 3.2}, {85.5, 18.3}}},
    {.name = "linear",
     .title = "linear search",
     .origin = "thesis 2.3.1",
     .file = "relievo/techniques/linear.glsl",
     .maps = kDepthMaps,
     .parameters = kLinearParameters,
     .errors = {{1.51, 0.261}, {2.26, 0.653}}},
    {.name = "parallax-occlusion",
     .title = "parallax occlusion mapping",
     .origin = "Tatarchuk 2006",
     .file = "relievo/techniques/parallax_occlusion.glsl",
     .maps = kDepthMaps,
     .parameters = kOcclusionParameters,
     .errors = {{5.13, 0.434}, {2.05, 0.296}}},
    {.name = "relief",
     .title = "relief mapping",
     .origin = "Policarpo, Oliveira, Comba 2005",
     .file = "relievo/techniques/relief.glsl",
     .maps = kDepthMaps,
     .parameters = kReliefParameters,
     .errors = {{3.94, 0.405}, {5.28, 0.631}}},
    {.name = "interval",
     .title = "interval mapping",
     .origin = "Risser, Shah, Pattanaik 2006",
     .file = "relievo/techniques/interval.glsl",
     .maps = kDepthMaps,
     .parameters = kIntervalParameters,
     .errors = {{3.94, 0.397}, {5.26, 0.627}}},
    {.name = "sphere",
     .title = "sphere tracing",
     .origin = "Donnelly 2005",
     .file = "relievo/techniques/sphere.glsl",
     .maps = kVolumeMaps,
     .parameters = kSkipParameters,
     .errors = {{3.99, 0.292}, {1.14, 0.124}}},
    {.name = "safety-zones",
     .title = "dilation and erosion",
     .origin = "Kolb, Rezk-Salama 2005",
     .file = "relievo/techniques/safety_zones.glsl",
     .maps = kExtremaMaps,
     .parameters = kSkipParameters,
     .errors = {{6.97, 0.62}, {0.984, 0.124}}},
    {.name = "cylinder",
     .title = "cylinder tracing",
     .origin = "Baboud, Décoret 2006",
     .file = "relievo/techniques/cylinder.glsl",
     .maps = kCylinderMaps,
     .parameters = kSkipParameters,
     .errors = {{1.76, 0.135}, {1.09, 0.11}}},
    {.name = "cone-step",
     .title = "cone stepping, as published",
     .origin = "Dummer 2006",
     .file = "relievo/techniques/cone_step.glsl",
     .maps = kConeMaps,
     .parameters = kConeStepParameters,
     .errors = {{0.0, 0.000199}, {0.05, 0.0022}}},
    {.name = "relaxed-step",
     .title = "relaxed cone stepping, as published",
     .origin = "Policarpo, Oliveira 2007",
     .file = "relievo/techniques/relaxed_step.glsl",
     .maps = kRelaxedMaps,
     .parameters = kConeStepParameters,
     .errors = {{0.0, 0.00121}, {0.05, 0.00279}}},
    {.name = "cone",
     .title = "cone tracing, cell by cell",
     .origin = "Dummer 2006; ours",
     .file = "relievo/techniques/cone.glsl",
     .maps = kConeMaps,
     .parameters = kConeParameters,
     .errors = {{0.0, 1e-5}, {0.0, 1e-5}}},
    {.name = "relaxed",
     .title = "relaxed cones, cell by cell, and binary search",
     .origin = "Policarpo, Oliveira 2007; ours",
     .file = "relievo/techniques/relaxed.glsl",
     .maps = kRelaxedMaps,
     .parameters = kConeParameters,
     .errors = {{0.0, 0.000985}, {0.0, 0.00227}}},
    {.name = "relaxed-secant",
     .title = "relaxed cones, cell by cell, and secant search",
     .origin = "Policarpo, Oliveira 2007; ours",
     .file = "relievo/techniques/relaxed_secant.glsl",
     .maps = kRelaxedMaps,
     .parameters = kRelaxedSecantParameters,
     .errors = {{0.0, 0.000272}, {0.0, 0.00465}}},
    {.name = "quadtree",
     .title = "quadtree displacement mapping",
     .origin = "Drobot 2010",
     .file = "relievo/techniques/quadtree.glsl",
     .maps = kPyramidMaps,
     .parameters = kPyramidParameters,
     .errors = {{23.7, 1.88}, {38.0, 4.2}}},
    {.name = "pyramid",
     .title = "exact hits by a depth pyramid",
     .origin = "Oh, Ki, Lee 2006; Tevs, Ihrke, Seidel 2008",
     .file = "relievo/techniques/pyramid.glsl",
     .maps = kPyramidMaps,
     .parameters = kPyramidParameters,
     .errors = {{0.0, 1e-5}, {0.0, 1e-5}}},
    {.name = "exact",
     .title = "exact hits by roof cones",
     .origin = "ours",
     .file = "relievo/techniques/exact.glsl",
     .maps = kRoofMaps,
     .parameters = kExactParameters,
     .errors = {{0.0, 1e-5}, {0.0, 1e-5}}},
    {.name = "auto",
     .title = "no more than can be seen",
     .origin = "ours",
     .file = "relievo/techniques/auto.glsl",
     .maps = kRoofMaps,
     .parameters = kAutoParameters,
     .errors = {{0.0, 0.31}, {40.0, 0.748}}},
};

constexpr Technique kGivenHits = {.name = "reference",
                                  .title = "exact reference",
                                  .origin = "double precision, on the CPU",
                                  .file = "relievo/techniques/given.glsl",
                                  .maps = kDepthMaps,
                                  .parameters = {},
                                  .isSearch = false};

constexpr Technique kMiddle = {.name = "middle",
                               .title = "middle plane",
                               .origin = "ours",
                               .file = "relievo/techniques/middle.glsl",
                               .maps = kDepthMaps,
                               .parameters = {},
                               .isSearch = false};

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

const Technique& middleTechnique() {
    return kMiddle;
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

void requireInRange(const Technique& technique, const TechniqueParameter& parameter, double value) {
    const bool whole = std::nearbyint(value) == value;
    if (!(value >= parameter.minimum && value <= parameter.maximum) ||
        (parameter.isInteger && !whole))
        throw textures::InputError(fmt::format("{} {}: {} is not {} from {} to {}", technique.name,
                                               parameter.name, value,
                                               parameter.isInteger ? "a whole number" : "a number",
                                               parameter.minimum, parameter.maximum));
}

const TechniqueParameter* budgetParameter(const Technique& technique) {
    const auto found = std::ranges::find_if(technique.parameters, &TechniqueParameter::isBudget);
    return found == technique.parameters.end() ? nullptr : &*found;
}

}  // namespace relievo::materials
