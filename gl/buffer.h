#pragma once

#include <glad/gl.h>

#include <cstddef>
#include <span>

namespace relievo::gl {

/// An owning buffer object of immutable size. Move only.
class Buffer {
  public:
    Buffer() = default;
    /// A buffer that holds a copy of `bytes`.
    explicit Buffer(std::span<const std::byte> bytes);
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    [[nodiscard]] GLuint id() const noexcept { return id_; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

  private:
    GLuint id_ = 0;
    std::size_t size_ = 0;
};

/// An owning vertex array. Move only.
class VertexArray {
  public:
    VertexArray();
    ~VertexArray();
    VertexArray(VertexArray&& other) noexcept;
    VertexArray& operator=(VertexArray&& other) noexcept;

    /// Attribute `location` reads `components` floats at `offset` of each `stride` bytes.
    void attribute(GLuint location, const Buffer& buffer, int components, std::size_t stride,
                   std::size_t offset);
    /// The indices (unsigned int) for glDrawElements.
    void indices(const Buffer& buffer);
    void bind() const;

  private:
    GLuint id_ = 0;
};

}  // namespace relievo::gl
