#pragma once

#include <span>
#include <string_view>

#include "materials/technique_registry.h"

namespace relievo::materials {

/// What a search of a solid can show.
struct SolidCapabilities {
    bool extrusion = false;
    bool revolution = false;
    bool profiles = false;   ///< extrusions whose offset changes with the depth
    bool compounds = false;  ///< several parts
};

/// One search of solids. Adding one is a GLSL file in shaders/relievo/solids/, which defines
/// searchSolid, and an entry here.
struct SolidTechnique {
    Technique technique;  ///< reads no maps of reliefs
    SolidCapabilities capabilities;
};

/// All of them, ours first.
std::span<const SolidTechnique> solidTechniques();

/// The one of that name. Throws textures::InputError, listing the names.
const SolidTechnique& findSolidTechnique(std::string_view name);

}  // namespace relievo::materials
