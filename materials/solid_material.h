#pragma once

#include <glad/gl.h>

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "gl/buffer.h"
#include "materials/relief_material.h"
#include "materials/shape_textures.h"
#include "materials/solid_block.h"
#include "materials/solid_registry.h"
#include "shaders/shader_library.h"
#include "solids/solid.h"

namespace relievo::materials {

/// A solid shown with one search: what a renderer needs to draw it, sunk into a surface or in a box
/// of its own. All that is public may change every frame; what is drawn follows.
///
/// The renderer's fragment shader includes `files()` and then "relievo/solid_trace.glsl", with
/// `defines()` in front, and calls traceSolid.
class SolidMaterial {
  public:
    /// Shapes are uploaded to `shapes` when the solid is first drawn. Throws textures::InputError
    /// when there are no parts, too many, or of a kind or profile that the search does not show.
    SolidMaterial(std::shared_ptr<ShapeTextureCache> shapes, solids::Compound parts,
                  const SolidTechnique& technique);

    /// Sets a parameter of the search. Throws textures::InputError for an unknown name or a value
    /// out of range.
    void setParameter(std::string_view name, double value);
    [[nodiscard]] double parameter(std::string_view name) const;

    /// The files of the shader library that the shader text must include, in this order.
    [[nodiscard]] std::vector<std::string_view> files() const;
    /// What the shader text must define for this solid.
    [[nodiscard]] std::vector<shaders::Define> defines() const;
    /// The files for a text that only searches.
    [[nodiscard]] std::vector<std::string_view> searchFiles() const;
    /// Binds the maps to texture units from `firstUnit`, the numbers to the uniform block, and sets
    /// the uniforms of `program`; of those of the solid it may lack any. Returns the first unit
    /// that stays free. Throws textures::InputError as solidBlock and requireShown do.
    GLuint bind(GLuint program, GLuint firstUnit = 0) const;
    /// The same for a program that only searches.
    GLuint bindSearch(GLuint program, GLuint firstUnit = 0) const;

    [[nodiscard]] const SolidTechnique& technique() const noexcept { return *technique_; }
    [[nodiscard]] bool isInBox() const noexcept { return boxFromWhole.has_value(); }
    /// Whether its search reads creases of a part.
    [[nodiscard]] bool isCreased() const;

    /// The parts. Profiles, extensions, axes, windows and placements may change, also shapes, but
    /// not the number and the kinds of the parts.
    solids::Compound compound;
    std::vector<PartLook> looks;  ///< one a part
    /// The box that the solid is in, or the window of a surface, in the space of the whole.
    glm::dvec3 low{0.0};
    glm::dvec3 high{1.0};
    /// Of a solid in a box: from the space of the whole to the world, affine and invertible. None:
    /// it is sunk into a surface.
    std::optional<glm::dmat4> boxFromWhole;
    float depthScale = 0.1f;  ///< of a solid in a surface: the depth of z = 1, in tile widths, ≥ 0
    bool hasFloor = true;     ///< likewise: the surface goes on at z = 1 around the solid
    bool shadowsItself = true;  ///< by light rays, which are searched as well
    /// A relief on walls and caps, where the part's picture lies; with the technique `normal` a
    /// bump map. Its slopes, window and depth scale are its own; it casts no shadows.
    std::optional<ReliefMaterial> relief;
    glm::vec2 pictureTiles{1.0f};  ///< of pictures and the relief, in a tile of the texturing, > 0

  private:
    const TechniqueParameter& find(std::string_view name, std::size_t& place) const;

    std::shared_ptr<ShapeTextureCache> shapes_;
    const SolidTechnique* technique_;
    std::vector<double> values_;            // of the search's parameters
    mutable std::vector<std::byte> bytes_;  // what the buffer holds
    mutable gl::Buffer buffer_;
};

}  // namespace relievo::materials
