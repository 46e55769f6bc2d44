#pragma once

#include <glad/gl.h>

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/program.h"
#include "gl/texture.h"
#include "shaders/shader_library.h"
#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::materials {

/// How a surface answers light: a file of shaders/relievo/shading/.
enum class ShadingModel {
    BlinnPhong,  ///< albedo under one white highlight
    Microfacet,  ///< metallic-roughness, with the meanings of glTF 2.0
};

/// What of the shading is no picture.
struct Shading {
    ShadingModel model = ShadingModel::BlinnPhong;
    float roughness = 0.5f;  ///< in [0,1], where no picture has it; of ShadingModel::Microfacet
    float metalness = 0.0f;  ///< likewise

    friend bool operator==(const Shading&, const Shading&) = default;
};

/// One picture of the usual texture set, and how it goes to the GPU.
struct SurfaceTextureFormat {
    std::string_view name;     ///< "albedo", "roughness", "metalness", "occlusion", "orm"
    std::string_view sampler;  ///< in shaders/relievo/shading/appearance.glsl
    std::string_view define;   ///< that makes the text read it
    int channels;
    GLenum internalFormat;
    bool isMicrofacetOnly;
};

/// All of them. `orm` holds occlusion, roughness and metalness as red, green and blue.
std::span<const SurfaceTextureFormat> surfaceTextureFormats();

/// The pictures of a surface besides its relief, on the CPU: values in [0,1], albedo encoded as
/// sRGB. Each may be of any size of its own.
struct TextureSet {
    /// Planes of one size for each picture, as many as its format has channels. With `orm` there is
    /// no roughness, metalness or occlusion besides.
    std::map<std::string, std::vector<textures::Plane>, std::less<>> pictures;
    /// The depth scale that the occlusion was built for: it follows the depth scale then. 0: it is
    /// the same at every one.
    float occlusionScale = 0.0f;
};

/// A texture set on the GPU. A picture that the shading does not read is not uploaded. Needs a
/// current context whenever it is used.
class SurfaceTextures {
  public:
    /// Pictures repeat like the relief.
    explicit SurfaceTextures(TextureSet set = {},
                             textures::WrapMode wrap = textures::WrapMode::Repeat);

    /// What the shader text must define.
    [[nodiscard]] std::vector<shaders::Define> defines(const Shading& shading) const;

    /// Binds what the shading reads to texture units from `firstUnit` and sets the uniforms of
    /// `program`, whose text had `defines`. Returns the first unit that stays free.
    GLuint bind(gl::Program& program, const Shading& shading, GLuint firstUnit);

    /// The pictures on the GPU so far.
    [[nodiscard]] std::size_t uploadedCount() const noexcept { return textures_.size(); }

  private:
    /// Whether there is a picture that the shading reads.
    [[nodiscard]] bool reads(const SurfaceTextureFormat& format, const Shading& shading) const;
    [[nodiscard]] bool has(std::string_view name) const { return set_.pictures.contains(name); }
    const gl::Texture& texture(const SurfaceTextureFormat& format);

    TextureSet set_;
    textures::WrapMode wrap_;
    std::map<std::string_view, gl::Texture> textures_;
};

}  // namespace relievo::materials
