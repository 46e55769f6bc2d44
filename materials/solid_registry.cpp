#include "materials/solid_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "textures/input_error.h"

namespace relievo::materials {
namespace {

constexpr TechniqueParameter kSolidParameters[] = {
    {"solid-steps", "relievoSolidSteps", "cells that a ray may look at before it gives up", 1,
     65536, 16384, true, true},
};

constexpr SolidTechnique kTechniques[] = {
    {.technique = {.name = "solid",
                   .title = "exact solids",
                   .origin = "ours",
                   .file = "relievo/solids/exact.glsl",
                   .maps = {},
                   .parameters = kSolidParameters},
     .capabilities = {.extrusion = true, .revolution = true, .profiles = true, .compounds = true}},
};

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

}  // namespace relievo::materials
