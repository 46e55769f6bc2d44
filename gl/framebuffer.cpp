#include "gl/framebuffer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

#include "gl/context.h"

namespace relievo::gl {
namespace {

GLuint createFramebuffer() {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    return id;
}

const char* statusName(GLenum status) noexcept {
    switch (status) {
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "a format that cannot be drawn to";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "a combination of formats that the driver does not support";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "no attachment";
        default:
            return "incomplete";
    }
}

/// All of level 0, its rows turned round: the first row of the result is the last of the texture.
std::vector<float> readRowsFromTop(const Texture& texture, GLenum format, int channels) {
    const std::size_t rowLength =
        static_cast<std::size_t>(texture.width()) * static_cast<std::size_t>(channels);
    const auto rows = static_cast<std::size_t>(texture.height());
    std::vector<float> texels(rowLength * rows);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture.id(), 0, format, GL_FLOAT,
                      static_cast<GLsizei>(texels.size() * sizeof(float)), texels.data());
    for (std::size_t row = 0; row < rows / 2; ++row) {
        const auto upper = texels.begin() + static_cast<std::ptrdiff_t>(row * rowLength);
        const auto lower =
            texels.begin() + static_cast<std::ptrdiff_t>((rows - 1 - row) * rowLength);
        std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(rowLength), lower);
    }
    return texels;
}

}  // namespace

void deleteFramebuffer(GLuint id) noexcept {
    glDeleteFramebuffers(1, &id);
}

Framebuffer::Framebuffer(int width, int height, std::span<const GLenum> colorFormats)
    : width_(width),
      height_(height),
      depth_(width, height, GL_DEPTH_COMPONENT32F),
      name_(createFramebuffer()) {
    std::vector<GLenum> drawBuffers;
    for (const GLenum format : colorFormats) {
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(colors_.size());
        colors_.emplace_back(width, height, format);
        glNamedFramebufferTexture(id(), attachment, colors_.back().id(), 0);
        drawBuffers.push_back(attachment);
    }
    glNamedFramebufferTexture(id(), GL_DEPTH_ATTACHMENT, depth_.id(), 0);
    glNamedFramebufferDrawBuffers(id(), static_cast<GLsizei>(drawBuffers.size()),
                                  drawBuffers.data());
    const GLenum status = glCheckNamedFramebufferStatus(id(), GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw GlError(fmt::format("a framebuffer of {} x {} with the formats {:#06x}: {} ({:#06x})",
                                  width, height, fmt::join(colorFormats, ", "), statusName(status),
                                  status));
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, id());
    glViewport(0, 0, width_, height_);
}

void Framebuffer::clearColor(int attachment, float x, float y, float z, float w) {
    static_cast<void>(color(attachment));  // there must be one
    const float value[] = {x, y, z, w};
    glClearNamedFramebufferfv(id(), GL_COLOR, attachment, value);
}

void Framebuffer::clearDepth(float depth) {
    glClearNamedFramebufferfv(id(), GL_DEPTH, 0, &depth);
}

std::vector<float> Framebuffer::read(int attachment) const {
    return readRowsFromTop(color(attachment), GL_RGBA, 4);
}

std::vector<float> Framebuffer::readDepth() const {
    return readRowsFromTop(depth_, GL_DEPTH_COMPONENT, 1);
}

}  // namespace relievo::gl
