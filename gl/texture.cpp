#include "gl/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "gl/context.h"

namespace relievo::gl {
namespace {

GLuint createTexture(bool isArray) {
    GLuint id = 0;
    glCreateTextures(isArray ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &id);
    return id;
}

int limit(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void checkSize(int width, int height, int layers) {
    const int maxSize = limit(GL_MAX_TEXTURE_SIZE);
    const int maxLayers = limit(GL_MAX_ARRAY_TEXTURE_LAYERS);
    if (width < 1 || height < 1 || layers < 0 || width > maxSize || height > maxSize ||
        layers > maxLayers)
        throw GlError(fmt::format(
            "a texture of {} x {} texels and {} layers: the driver takes 1 to {} texels "
            "a side and up to {} layers",
            width, height, layers, maxSize, maxLayers));
}

}  // namespace

void deleteTexture(GLuint id) noexcept {
    glDeleteTextures(1, &id);
}

Texture::Texture(int width, int height, GLenum internalFormat, int layers, int levels)
    : width_(width), height_(height), layers_(layers), levels_(levels) {
    checkSize(width, height, layers);
    name_ = ObjectName<deleteTexture>(createTexture(layers > 0));
    if (layers > 0)
        glTextureStorage3D(id(), levels, internalFormat, width, height, layers);
    else
        glTextureStorage2D(id(), levels, internalFormat, width, height);
    // Not glGetError, which may hold an error of someone else.
    GLint isAllocated = GL_FALSE;
    glGetTextureParameteriv(id(), GL_TEXTURE_IMMUTABLE_FORMAT, &isAllocated);
    if (isAllocated == GL_FALSE)
        throw GlError(fmt::format(
            "the driver refuses a texture of {} x {} texels, {} layers, {} levels, format {:#06x}",
            width, height, layers, levels, internalFormat));
    setSampling(GL_CLAMP_TO_EDGE, GL_NEAREST);
}

void Texture::upload(std::span<const float> texels, int channels, int layer, int level) {
    constexpr std::array<GLenum, 4> kFormats = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    if (channels < 1 || channels > 4)
        throw GlError(fmt::format("a texel has 1 to 4 channels, not {}", channels));
    if (layer < 0 || layer >= (layers_ > 0 ? layers_ : 1))
        throw GlError(fmt::format("a texture of {} layers has no layer {}", layers_, layer));
    if (level < 0 || level >= levels_)
        throw GlError(fmt::format("a texture of {} levels has no level {}", levels_, level));
    const int width = std::max(width_ >> level, 1);
    const int height = std::max(height_ >> level, 1);
    const std::size_t expected = static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(height) *
                                 static_cast<std::size_t>(channels);
    if (texels.size() != expected)
        throw GlError(
            fmt::format("a texture of {} x {} texels with {} channels takes {} values, not {}",
                        width, height, channels, expected, texels.size()));

    const GLenum format = kFormats[channels - 1];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (layers_ > 0)
        glTextureSubImage3D(id(), level, 0, 0, layer, width, height, 1, format, GL_FLOAT,
                            texels.data());
    else
        glTextureSubImage2D(id(), level, 0, 0, width, height, format, GL_FLOAT, texels.data());
}

void Texture::setSampling(GLenum wrap, GLenum filter) {
    glTextureParameteri(id(), GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
    glTextureParameteri(id(), GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
    glTextureParameteri(id(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTextureParameteri(id(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
}

void Texture::bind(GLuint unit) const {
    glBindTextureUnit(unit, id());
}

}  // namespace relievo::gl
