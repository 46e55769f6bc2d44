#pragma once

#include <glad/gl.h>

#include <span>

namespace relievo::gl {

/// An owning two-dimensional texture (or array when layers > 0) of immutable storage. Move only.
class Texture {
  public:
    Texture() = default;
    /// `internalFormat` such as GL_R32F; `layers` 0 makes GL_TEXTURE_2D, otherwise
    /// GL_TEXTURE_2D_ARRAY. Throws GlError for sizes that the driver refuses.
    Texture(int width, int height, GLenum internalFormat, int layers = 0, int levels = 1);
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;

    /// Uploads level 0 of one layer from tightly packed rows, the first row being v = 0 (the top
    /// of the picture). `channels` is 1 to 4 floats a texel.
    void upload(std::span<const float> texels, int channels, int layer = 0);
    /// Sets the wrap mode of both axes and the filter (GL_LINEAR or GL_NEAREST).
    void setSampling(GLenum wrap, GLenum filter);
    void bind(GLuint unit) const;

    [[nodiscard]] GLuint id() const noexcept { return id_; }
    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }

  private:
    GLuint id_ = 0;
    int width_ = 0;
    int height_ = 0;
    int layers_ = 0;
};

}  // namespace relievo::gl
