#pragma once

#include <glad/gl.h>

#include <span>
#include <vector>

#include "gl/object_name.h"
#include "gl/texture.h"

namespace relievo::gl {

void deleteFramebuffer(GLuint id) noexcept;

/// An owning framebuffer object with colour textures and a 32-bit float depth texture, all of one
/// size. Row 0 of what it holds is the bottom of the picture (OpenGL's convention); `read` returns
/// rows from the top. Move only. Its context must be current whenever it is used, and when it is
/// destroyed.
class Framebuffer {
  public:
    Framebuffer() = default;
    /// One colour attachment a format (GL_RGBA8, GL_RGBA32F, …); there may be none. Throws GlError
    /// when incomplete.
    Framebuffer(int width, int height, std::span<const GLenum> colorFormats);

    /// Makes it the target of drawing and sets the viewport to its size.
    void bind() const;
    /// Clears one colour attachment to (x,y,z,w).
    void clearColor(int attachment, float x, float y, float z, float w);
    void clearDepth(float depth = 1.0f);
    /// RGBA floats of one colour attachment, 4·width·height, rows from the top of the picture. The
    /// format must be a float or normalised one.
    [[nodiscard]] std::vector<float> read(int attachment) const;
    /// Window depths, width·height, rows from the top of the picture.
    [[nodiscard]] std::vector<float> readDepth() const;

    [[nodiscard]] GLuint id() const noexcept { return name_.id(); }
    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    /// Throws std::out_of_range when there is no such attachment, as the functions above do.
    [[nodiscard]] const Texture& color(int attachment) const { return colors_.at(attachment); }
    [[nodiscard]] const Texture& depth() const noexcept { return depth_; }

  private:
    int width_ = 0;
    int height_ = 0;
    std::vector<Texture> colors_;
    Texture depth_;
    ObjectName<deleteFramebuffer> name_;
};

}  // namespace relievo::gl
