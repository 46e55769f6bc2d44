#pragma once

#include <span>
#include <string>
#include <string_view>

#include "materials/technique_registry.h"
#include "solids/solid.h"

namespace relievo::materials {

/// Profiles of extrusions that a search can show.
enum class ShownProfiles {
    Upright,   ///< one piece that does not change with the depth
    Bevels,    ///< one piece, which grows with the depth or does not change
    Chamfers,  ///< the same, or one such piece and an upright one that goes on from it
    All
};

/// What a search of a solid can show.
struct SolidCapabilities {
    bool extrusion = false;
    bool revolution = false;
    ShownProfiles profiles = ShownProfiles::Upright;  ///< of extrusions
    bool compounds = false;                           ///< several parts
    bool creases = false;  ///< sharp corners; others see the distances alone
};

/// One search of solids. Adding one is a GLSL file in shaders/relievo/solids/, which defines
/// searchSolid, and an entry here.
struct SolidTechnique {
    Technique technique;  ///< reads no maps of reliefs
    SolidCapabilities capabilities;
};

/// All of them: ours, then those of the thesis to compare with.
std::span<const SolidTechnique> solidTechniques();

/// The one of that name. Throws textures::InputError, listing the names.
const SolidTechnique& findSolidTechnique(std::string_view name);

/// What keeps `technique` from showing such a solid, as a sentence; "" when it shows it.
std::string solidProblem(const SolidTechnique& technique, const solids::Compound& compound);

/// Throws textures::InputError with solidProblem, unless that is "".
void requireShown(const SolidTechnique& technique, const solids::Compound& compound);

}  // namespace relievo::materials
