#pragma once

#include <glad/gl.h>

#include <span>
#include <vector>

#include "gl/texture.h"

namespace relievo::gl {

/// An owning framebuffer object with colour textures and a 32-bit float depth texture, all of one
/// size. Row 0 of what it holds is the bottom of the picture (OpenGL's convention); `read` returns
/// rows from the top. Move only.
class Framebuffer {
  public:
    Framebuffer() = default;
    /// One colour attachment a format (GL_RGBA8, GL_RGBA32F, …). Throws GlError when incomplete.
    Framebuffer(int width, int height, std::span<const GLenum> colorFormats);
    ~Framebuffer();
    Framebuffer(Framebuffer&& other) noexcept;
    Framebuffer& operator=(Framebuffer&& other) noexcept;

    /// Makes it the target of drawing and sets the viewport to its size.
    void bind() const;
    /// Clears one colour attachment to (x,y,z,w).
    void clearColor(int attachment, float x, float y, float z, float w);
    void clearDepth(float depth = 1.0f);
    /// RGBA floats of one colour attachment, 4·width·height, rows from the top of the picture.
    [[nodiscard]] std::vector<float> read(int attachment) const;
    /// Window depths, width·height, rows from the top of the picture.
    [[nodiscard]] std::vector<float> readDepth() const;

    [[nodiscard]] GLuint id() const noexcept { return id_; }
    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] const Texture& color(int attachment) const { return colors_.at(attachment); }

  private:
    GLuint id_ = 0;
    int width_ = 0;
    int height_ = 0;
    std::vector<Texture> colors_;
    Texture depth_;
};

}  // namespace relievo::gl
