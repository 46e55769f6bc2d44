#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solids/solid.h"

namespace relievo::materials {

/// How a picture is put on a part (thesis 4.6.3); the values are RELIEVO_TEXTURING_… of
/// shaders/relievo/constants.h.
enum class SolidTexturing { Top, Front, Diagonal, Cylinder, Sphere, Box };

/// "top", "front", "diagonal", "cylinder", "sphere", "box": the words of command lines and scene
/// files.
std::string_view solidTexturingName(SolidTexturing texturing) noexcept;
/// The inverse. Throws textures::InputError, listing the names.
SolidTexturing findSolidTexturing(std::string_view name);

/// What a part looks like.
struct PartLook {
    glm::vec3 color{0.6f};  ///< linear RGB; what a picture is multiplied by
    SolidTexturing texturing = SolidTexturing::Box;
};

/// The parts of a solid as the uniform block RelievoSolid of shaders/relievo/solid/block.glsl has
/// them, in its layout std140. `looks` has one entry a part. Throws textures::InputError for no
/// parts, for more than solids::kMostParts, and for profiles of more than solids::kMostPieces.
std::vector<std::byte> solidBlock(const solids::Compound& compound,
                                  std::span<const PartLook> looks);

}  // namespace relievo::materials
