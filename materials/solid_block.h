#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "solids/solid.h"
#include "solids/solid_texturing.h"

namespace relievo::materials {

/// What a part looks like.
struct PartLook {
    glm::vec3 color{0.6f};  ///< linear RGB; what a picture is multiplied by
    solids::SolidTexturing texturing = solids::SolidTexturing::Box;
};

/// The parts of a solid as the uniform block RelievoSolid of shaders/relievo/solid/block.glsl has
/// them, in its layout std140. `looks` has one entry a part. Throws textures::InputError for no
/// parts, for more than solids::kMostParts, and for profiles of more than solids::kMostPieces.
std::vector<std::byte> solidBlock(const solids::Compound& compound,
                                  std::span<const PartLook> looks);

}  // namespace relievo::materials
