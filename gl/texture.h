#pragma once

#include <glad/gl.h>

#include <span>

#include "gl/object_name.h"

namespace relievo::gl {

void deleteTexture(GLuint id) noexcept;

/// An owning two-dimensional texture (or array when layers > 0) of immutable storage. Move only.
/// Its context must be current whenever it is used, and when it is destroyed.
class Texture {
  public:
    Texture() = default;
    /// `internalFormat` such as GL_R32F; `layers` 0 makes GL_TEXTURE_2D, otherwise
    /// GL_TEXTURE_2D_ARRAY; `levels` counts the levels of the mip chain. Samples with
    /// GL_CLAMP_TO_EDGE and GL_NEAREST until told otherwise. Throws GlError for sizes and formats
    /// that the driver refuses.
    Texture(int width, int height, GLenum internalFormat, int layers = 0, int levels = 1);

    /// Uploads one level of one layer from tightly packed rows, the first row being v = 0 (the top
    /// of the picture). `channels` is 1 to 4 floats a texel. Throws GlError when `texels` does not
    /// hold as many values as the level's texels have channels, or there is no such layer or level.
    void upload(std::span<const float> texels, int channels, int layer = 0, int level = 0);
    /// Sets the wrap mode of both axes (GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE) and the
    /// filter (GL_LINEAR or GL_NEAREST; only level 0 is sampled).
    void setSampling(GLenum wrap, GLenum filter);
    /// Binds it to a texture unit, the number that the sampler's uniform is set to.
    void bind(GLuint unit) const;

    [[nodiscard]] GLuint id() const noexcept { return name_.id(); }
    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }

  private:
    ObjectName<deleteTexture> name_;
    int width_ = 0;
    int height_ = 0;
    int layers_ = 0;
    int levels_ = 0;
};

}  // namespace relievo::gl
