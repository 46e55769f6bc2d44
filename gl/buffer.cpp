#include "gl/buffer.h"

#include <fmt/format.h>

#include "gl/context.h"

namespace relievo::gl {
namespace {

GLuint createBuffer() {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    return id;
}

GLuint createVertexArray() {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    return id;
}

}  // namespace

void deleteBuffer(GLuint id) noexcept {
    glDeleteBuffers(1, &id);
}

void deleteVertexArray(GLuint id) noexcept {
    glDeleteVertexArrays(1, &id);
}

Buffer::Buffer(std::span<const std::byte> bytes) : size_(bytes.size()) {
    if (bytes.empty())
        throw GlError("a buffer object holds at least one byte");
    name_ = ObjectName<deleteBuffer>(createBuffer());
    glNamedBufferStorage(id(), static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
    // Not glGetError, which may hold an error of someone else.
    GLint isAllocated = GL_FALSE;
    glGetNamedBufferParameteriv(id(), GL_BUFFER_IMMUTABLE_STORAGE, &isAllocated);
    if (isAllocated == GL_FALSE)
        throw GlError(fmt::format("the driver refuses a buffer of {} bytes", bytes.size()));
}

VertexArray::VertexArray() : name_(createVertexArray()) {}

void VertexArray::attribute(GLuint location, const Buffer& buffer, int components,
                            std::size_t stride, std::size_t offset) {
    const GLuint id = name_.id();
    glEnableVertexArrayAttrib(id, location);
    glVertexArrayAttribFormat(id, location, components, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(id, location, location);
    glVertexArrayVertexBuffer(id, location, buffer.id(), static_cast<GLintptr>(offset),
                              static_cast<GLsizei>(stride));
}

void VertexArray::indices(const Buffer& buffer) {
    glVertexArrayElementBuffer(name_.id(), buffer.id());
}

void VertexArray::bind() const {
    glBindVertexArray(name_.id());
}

}  // namespace relievo::gl
