#pragma once

#include <span>
#include <string_view>

#include "materials/technique_registry.h"

namespace relievo::materials {

/// The most that a method of self-shadowing is wrong: its share of pixels that are off by over a
/// tenth of the light, in per cent, on any of the sample reliefs, of 128² texels and 0.1 tile
/// widths deep, seen from 60° in a frame of 64² rays with the technique `exact`. Tests hold every
/// method to it; `relievo-bench shadow --size 128 --frame 64` prints it.
struct ShadowErrorBudget {
    struct At {
        double pointPercent = 0.0;  ///< under a light that is a point
        double discPercent = 0.0;   ///< under one of 10° across
    };
    At at45;  ///< light from 45° above the surface
    At at15;
};

/// One method of self-shadowing. Adding one is a GLSL file in shaders/relievo/shadows/ and an entry
/// here.
struct ShadowMethod {
    std::string_view name;    ///< on command lines
    std::string_view title;   ///< on pictures
    std::string_view origin;  ///< author and year
    std::string_view file;    ///< in the shader library
    /// Names of the maps that it reads (relief_maps.h), besides those of the technique.
    std::span<const std::string_view> maps;
    std::span<const TechniqueParameter> parameters;
    bool searches = false;  ///< light rays are searched by the technique, which must be a search
    bool isSoft = false;    ///< takes the size of the light into account
    ShadowErrorBudget errors = {};
};

/// All methods, the most exact first.
std::span<const ShadowMethod> shadowMethods();

/// The method that shows shadows found elsewhere, such as those of the exact reference on the CPU.
/// It reads them from the sampler `relievoGivenVisibility`, a texture of the frame's size. Not
/// listed.
const ShadowMethod& givenShadowMethod();

/// The method called `name`. Throws textures::InputError, listing the names, for an unknown one.
const ShadowMethod& findShadowMethod(std::string_view name);

/// What a benchmark varies to trade time for error, or null for a method without it.
const TechniqueParameter* budgetParameter(const ShadowMethod& method);

}  // namespace relievo::materials
