#pragma once

#include <glad/gl.h>

#include <cstddef>
#include <span>

#include "gl/object_name.h"

namespace relievo::gl {

void deleteBuffer(GLuint id) noexcept;
void deleteVertexArray(GLuint id) noexcept;

/// An owning buffer object of immutable size. Move only. Its context must be current whenever it is
/// used, and when it is destroyed.
class Buffer {
  public:
    Buffer() = default;
    /// A buffer that holds a copy of `bytes`. Throws GlError when there are none, or too many for
    /// the driver.
    explicit Buffer(std::span<const std::byte> bytes);

    [[nodiscard]] GLuint id() const noexcept { return name_.id(); }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

  private:
    ObjectName<deleteBuffer> name_;
    std::size_t size_ = 0;
};

/// An owning vertex array. Move only. Its context must be current whenever it is used, and when it
/// is destroyed. The buffers that it reads must outlive it.
class VertexArray {
  public:
    VertexArray();

    /// Attribute `location` reads `components` floats at `offset` of each `stride` bytes.
    void attribute(GLuint location, const Buffer& buffer, int components, std::size_t stride,
                   std::size_t offset);
    /// The indices (unsigned int) for glDrawElements.
    void indices(const Buffer& buffer);
    void bind() const;

  private:
    ObjectName<deleteVertexArray> name_;
};

}  // namespace relievo::gl
