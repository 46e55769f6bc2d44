#include "materials/solid_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "textures/input_error.h"

namespace relievo::materials {
namespace {

constexpr TechniqueParameter kSolidParameters[] = {
    {"solid-steps", "relievoSolidSteps", "cells that a ray may look at before it gives up", 1,
     65536, 16384, true, true},
};

// Of the thesis: 30 steps; 25 and 10 for bevels; 25, 10 and 25 for chamfers.
constexpr TechniqueParameter printedSteps(double defaultValue, std::string_view description) {
    return {"solid-steps", "relievoSolidSteps", description, 1, 16384, defaultValue, true, true};
}
constexpr TechniqueParameter kTolerance{
    "tolerance",
    "relievoSolidTolerance",
    "texels in front of the surface at which a search counts as having come to it",
    0,
    1,
    0.1,
    false,
    false};
constexpr TechniqueParameter kHalvings{"binary-steps",
                                       "relievoBinarySteps",
                                       "halvings of the step that went into the bevel",
                                       0,
                                       32,
                                       10,
                                       true,
                                       false};

constexpr TechniqueParameter kPrintedParameters[] = {printedSteps(30, "steps by the distance"),
                                                     kTolerance};
constexpr TechniqueParameter kPrintedBevelParameters[] = {printedSteps(25, "steps by the distance"),
                                                          kHalvings, kTolerance};
constexpr TechniqueParameter kPrintedChamferParameters[] = {
    printedSteps(25, "steps by the distance, to the bevel and to the wall below it"), kHalvings,
    kTolerance};

constexpr SolidTechnique kTechniques[] = {
    {.technique = {.name = "solid",
                   .title = "exact solids",
                   .origin = "ours",
                   .file = "relievo/solids/exact.glsl",
                   .maps = {},
                   .parameters = kSolidParameters},
     .capabilities = {.extrusion = true,
                      .revolution = true,
                      .profiles = ShownProfiles::All,
                      .compounds = true,
                      .creases = true}},
    {.technique = {.name = "extrusion-printed",
                   .title = "extrusion mapping",
                   .origin = "Halli 2009, algorithms 4.1 and 4.2",
                   .file = "relievo/solids/extrusion_printed.glsl",
                   .maps = {},
                   .parameters = kPrintedParameters},
     .capabilities = {.extrusion = true, .profiles = ShownProfiles::Upright}},
    {.technique = {.name = "bevel-printed",
                   .title = "bevelled extrusion mapping",
                   .origin = "Halli 2009, algorithm 4.3",
                   .file = "relievo/solids/bevel_printed.glsl",
                   .maps = {},
                   .parameters = kPrintedBevelParameters},
     .capabilities = {.extrusion = true, .profiles = ShownProfiles::Bevels}},
    {.technique = {.name = "chamfer-printed",
                   .title = "chamfered extrusion mapping",
                   .origin = "Halli 2009, algorithm 4.4",
                   .file = "relievo/solids/chamfer_printed.glsl",
                   .maps = {},
                   .parameters = kPrintedChamferParameters},
     .capabilities = {.extrusion = true, .profiles = ShownProfiles::Chamfers}},
    {.technique = {.name = "revolution-printed",
                   .title = "revolution mapping",
                   .origin = "Halli 2009, algorithm 4.5",
                   .file = "relievo/solids/revolution_printed.glsl",
                   .maps = {},
                   .parameters = kPrintedParameters},
     .capabilities = {.revolution = true}},
};

bool isUpright(const solids::ProfilePiece& piece) {
    return piece.topOffset == piece.bottomOffset;
}

bool isBevel(const solids::ProfilePiece& piece) {
    return piece.bottomOffset >= piece.topOffset && piece.top == 0.0;
}

bool isShown(ShownProfiles shown, const solids::Profile& profile) {
    const auto& pieces = profile.pieces;
    switch (shown) {
        case ShownProfiles::Upright:
            return pieces.size() == 1 && isUpright(pieces[0]);
        case ShownProfiles::Bevels:
            return pieces.size() == 1 && isBevel(pieces[0]);
        case ShownProfiles::Chamfers:
            return isShown(ShownProfiles::Bevels, profile) ||
                   (pieces.size() == 2 && isBevel(pieces[0]) && isUpright(pieces[1]) &&
                    pieces[0].bottomOffset == pieces[1].topOffset);
        case ShownProfiles::All:
            break;
    }
    return true;
}

std::string_view wordsFor(ShownProfiles shown) {
    switch (shown) {
        case ShownProfiles::Upright:
            return "upright walls";
        case ShownProfiles::Bevels:
            return "upright walls and bevels that grow down to the bottom";
        case ShownProfiles::Chamfers:
            return "upright walls, and bevels and chamfers that grow downwards";
        case ShownProfiles::All:
            break;
    }
    return "all profiles";
}

std::string solidProblem(const SolidTechnique& technique, const solids::Solid& solid) {
    const SolidCapabilities& can = technique.capabilities;
    const std::string_view name = technique.technique.name;
    const bool isRevolution = solid.kind == solids::SolidKind::Revolution;
    if (isRevolution ? !can.revolution : !can.extrusion)
        return fmt::format("the search \"{}\" shows {} only, not {}", name,
                           isRevolution ? "extrusions" : "revolutions",
                           isRevolution ? "revolutions" : "extrusions");
    if (!isRevolution && !isShown(can.profiles, solid.profile))
        return fmt::format("the search \"{}\" shows {} only, not this profile", name,
                           wordsFor(can.profiles));
    return "";
}

}  // namespace

std::span<const SolidTechnique> solidTechniques() {
    return kTechniques;
}

const SolidTechnique& findSolidTechnique(std::string_view name) {
    std::vector<std::string_view> names;
    for (const SolidTechnique& technique : kTechniques) {
        if (technique.technique.name == name)
            return technique;
        names.push_back(technique.technique.name);
    }
    throw textures::InputError(fmt::format("there is no search of solids \"{}\", expected {}", name,
                                           fmt::join(names, ", ")));
}

std::string solidProblem(const SolidTechnique& technique, const solids::Compound& compound) {
    if (compound.parts.size() > 1 && !technique.capabilities.compounds)
        return fmt::format("the search \"{}\" shows a single part, not {}",
                           technique.technique.name, compound.parts.size());
    for (const solids::SolidPart& part : compound.parts)
        if (const std::string problem = solidProblem(technique, part.solid); !problem.empty())
            return problem;
    return "";
}

void requireShown(const SolidTechnique& technique, const solids::Compound& compound) {
    if (const std::string problem = solidProblem(technique, compound); !problem.empty())
        throw textures::InputError(problem);
}

}  // namespace relievo::materials
