#include "materials/shape_textures.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "materials/relief_maps.h"
#include "shaders/relievo/constants.h"

namespace relievo::materials {
namespace {

std::vector<float> distanceTexels(const textures::ShapeMap& shape) {
    std::vector<float> texels(shape.distance.texels);
    for (float& texel : texels)
        texel *= static_cast<float>(shape.width());
    return texels;
}

// `value` with its last bit as given: at most the next float to it.
float withLastBit(float value, bool bit) {
    const auto bits = std::bit_cast<std::uint32_t>(value) & ~1U;
    return std::bit_cast<float>(bits | (bit ? 1U : 0U));
}

std::vector<float> creasedTexels(const textures::ShapeMap& shape) {
    const auto width = static_cast<float>(shape.width());
    const std::size_t count = shape.distance.texels.size();
    std::vector<float> texels(3 * count);
    for (std::size_t t = 0; t < count; ++t) {
        const float distance = shape.distance.texels[t];
        const float code = shape.creases.code.texels[t];
        const bool isLowered = code != 0.0f || shape.creases.step.texels[t] != distance;
        const float step = withLastBit(width * shape.creases.step.texels[t], isLowered);
        texels[3 * t] = step;
        if (!isLowered)
            continue;
        texels[3 * t + 1] = width * distance - step +
                            (code != 0.0f ? static_cast<float>(RELIEVO_SOLID_CREASE) : 0.0f);
        texels[3 * t + 2] = width * code;
    }
    return texels;
}

ShapeTextures upload(const textures::ShapeMap& shape, bool isSection, bool isCreased) {
    const GLenum wrap = isSection ? GL_CLAMP_TO_EDGE : glWrapMode(shape.wrap);
    const int width = shape.width();
    const int height = shape.height();
    ShapeTextures result{gl::Texture(width, height, isCreased ? GL_RGB32F : GL_R32F),
                         gl::Texture(width, height, GL_RG32F)};
    result.distances.upload(isCreased ? creasedTexels(shape) : distanceTexels(shape),
                            isCreased ? 3 : 1);
    result.distances.setSampling(wrap, GL_NEAREST);
    std::vector<float> texels(2 * shape.gradientX.texels.size());
    for (std::size_t k = 0; k < shape.gradientX.texels.size(); ++k) {
        texels[2 * k] = shape.gradientX.texels[k];
        texels[2 * k + 1] = shape.gradientY.texels[k];
    }
    result.gradients.upload(texels, 2);
    result.gradients.setSampling(wrap, GL_LINEAR);
    return result;
}

}  // namespace

const ShapeTextures& ShapeTextureCache::get(const std::shared_ptr<const textures::ShapeMap>& shape,
                                            bool isSection, bool isCreased) {
    const Key key(shape, isSection, isCreased && shape->isCreased());
    const auto found = textures_.find(key);
    if (found != textures_.end())
        return found->second;
    return textures_.emplace(key, upload(*shape, isSection, std::get<2>(key))).first->second;
}

}  // namespace relievo::materials
