#pragma once

#include <span>
#include <string>
#include <string_view>

namespace relievo::materials {

/// A number that a technique takes, and the uniform that carries it.
struct TechniqueParameter {
    std::string_view name;         ///< on command lines and in reports: "linear-steps"
    std::string_view uniform;      ///< in the technique's GLSL file
    std::string_view description;  ///< one line for --list and --help
    double minimum;
    double maximum;
    double defaultValue;
    bool isInteger;
    bool isBudget;  ///< the step budget: what a benchmark varies to trade time for error
};

/// The most that a technique is wrong, with its default parameters: on any of the sample reliefs,
/// of 128² texels and 0.1 tile widths deep, in a frame of 64² rays from 45° and from 15° above the
/// surface. Tests hold every technique to it.
struct ErrorBudget {
    struct At {
        double wrongPercent = 0.0;  ///< first hits that are off by over a texel, or not converged
        double meanTexels = 0.0;    ///< distance from the exact hit along the ray
    };
    At at45;
    At at15;
};

/// One search technique. Adding one is a GLSL file in shaders/relievo/techniques/ and an entry
/// here: the commands, the viewer, the tests and the benchmark list from this registry.
struct Technique {
    std::string_view name;    ///< on command lines
    std::string_view title;   ///< on pictures and plots
    std::string_view origin;  ///< author and year
    std::string_view file;    ///< in the shader library
    /// Names of the maps that the search reads (relief_maps.h). Slopes are no map of the search's,
    /// even where it follows them: ReliefMaterial::setSlopeSource.
    std::span<const std::string_view> maps;
    std::span<const TechniqueParameter> parameters;
    ErrorBudget errors = {};
    /// Looks for what is in the way of a ray, wherever that begins and ends; light rays can be
    /// searched with it.
    bool isSearch = true;
};

/// All techniques, the cheapest first.
std::span<const Technique> techniques();

/// The technique that searches nothing and shows hits found elsewhere, such as those of the exact
/// reference on the CPU, through the shading of all others. It reads them from the sampler
/// `relievoGivenHits` (u, v, z, t; t < 0 for a miss), a texture of the frame's size. Not listed.
const Technique& givenHitsTechnique();

/// What `auto` comes to where half of the relief's depth is less than its target all over what is
/// drawn: the plane halfway through the relief, without a search or its maps. Not listed; see
/// detail_choice.h.
const Technique& middleTechnique();

/// The technique called `name`. Throws textures::InputError, listing the names, for an unknown one.
const Technique& findTechnique(std::string_view name);

/// The parameter of `technique` called `name`. Throws textures::InputError, listing the names.
const TechniqueParameter& findParameter(const Technique& technique, std::string_view name);

/// Throws textures::InputError, which says the range, when a parameter of `technique` cannot have a
/// value: one out of range, or a fraction where an integer is expected.
void requireInRange(const Technique& technique, const TechniqueParameter& parameter, double value);

/// The step budget of `technique`, or null for one without (normal mapping).
const TechniqueParameter* budgetParameter(const Technique& technique);

}  // namespace relievo::materials
