#pragma once

#include <glad/gl.h>

#include <map>
#include <span>
#include <string_view>

#include "gl/texture.h"
#include "textures/map_set.h"

namespace relievo::materials {

/// How one map of a relief goes to the GPU. Adding a map kind is an entry in relief_maps.cpp.
struct ReliefMapFormat {
    std::string_view name;                       ///< "depth", "derivative", "cone"
    std::string_view sampler;                    ///< the sampler2D in the shader library
    std::span<const std::string_view> channels;  ///< of the map set, in the order r, g, b, a
    GLenum internalFormat;
    GLenum filter;
};

/// All maps that can go to the GPU.
std::span<const ReliefMapFormat> reliefMapFormats();

/// The format of the map called `name`; the name must be one of reliefMapFormats().
const ReliefMapFormat& reliefMapFormat(std::string_view name);

/// The maps of one relief on the GPU. Each is uploaded when it is first asked for, so maps that no
/// technique in use needs cost nothing. Needs a current context; share it between the materials
/// that show the same relief.
class ReliefMaps {
  public:
    /// `name` stands for the relief in error messages (usually its file). Throws
    /// textures::InputError when `maps` has no channel `depth`.
    ReliefMaps(textures::MapSet maps, std::string name);

    /// The texture of one map. Throws textures::InputError that names the channel the set lacks.
    const gl::Texture& texture(std::string_view mapName);
    /// Throws what `texture` would, without uploading anything.
    void require(std::string_view mapName) const;

    [[nodiscard]] const textures::MapSet& maps() const noexcept { return maps_; }

  private:
    textures::MapSet maps_;
    std::string name_;
    std::map<std::string_view, gl::Texture> textures_;
};

/// GL_REPEAT, GL_MIRRORED_REPEAT or GL_CLAMP_TO_EDGE.
GLenum glWrapMode(textures::WrapMode wrap) noexcept;

}  // namespace relievo::materials
