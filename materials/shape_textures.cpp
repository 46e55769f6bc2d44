#include "materials/shape_textures.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
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

// The largest float of at most `value` whose last bits, those of `mask`, are 0, with `last` in
// their place. No number is so small that texture units may take it for 0: the bits would be lost.
float withLastBits(float value, std::uint32_t mask, std::uint32_t last) {
    constexpr float kSmallest = 1e-30f;
    if (last != 0 && std::abs(value) < kSmallest)
        value = -kSmallest;
    auto bits = std::bit_cast<std::uint32_t>(value);
    if (value < 0.0f)
        bits += mask;
    return std::bit_cast<float>((bits & ~mask) | last);
}

// How many units make at least `below`, of which the most are `depth` > 0.
std::uint32_t unitsOf(double below, double depth) {
    constexpr double kDeepest = RELIEVO_SOLID_MARK_DEEPEST;
    return static_cast<std::uint32_t>(
        std::clamp(std::ceil(kDeepest * below / depth), 0.0, kDeepest));
}

// Both channels of a texel that is lowered for steps, all in texels.
glm::vec2 loweredTexel(float distance, double step, float code, double depth) {
    const float stored = withLastBits(distance, RELIEVO_SOLID_MARK_BITS, 0);
    const std::uint32_t units = unitsOf(stored - step, depth);
    const std::uint32_t marks = RELIEVO_SOLID_MARK_LOWERED |
                                (code != 0.0f ? RELIEVO_SOLID_MARK_CREASED : 0U) |
                                units * RELIEVO_SOLID_MARK_UNIT;
    return {withLastBits(stored, RELIEVO_SOLID_MARK_BITS, marks), code};
}

std::vector<float> creasedTexels(const textures::ShapeMap& shape) {
    const auto width = static_cast<float>(shape.width());
    const double depth = shape.width() * textures::creaseDepth(shape);
    const std::size_t count = shape.distance.texels.size();
    std::vector<float> texels(2 * count);
    for (std::size_t t = 0; t < count; ++t) {
        const float distance = width * shape.distance.texels[t];
        const float code = width * shape.creases.code.texels[t];
        const bool isLowered =
            code != 0.0f || shape.creases.step.texels[t] != shape.distance.texels[t];
        const glm::vec2 texel =
            isLowered
                ? loweredTexel(distance, double{width} * shape.creases.step.texels[t], code, depth)
                : glm::vec2(withLastBits(distance, RELIEVO_SOLID_MARK_LOWERED, 0), 0.0f);
        texels[2 * t] = texel.x;
        texels[2 * t + 1] = texel.y;
    }
    return texels;
}

ShapeTextures upload(const textures::ShapeMap& shape, bool isSection, bool isCreased) {
    const GLenum wrap = isSection ? GL_CLAMP_TO_EDGE : glWrapMode(shape.wrap);
    const int width = shape.width();
    const int height = shape.height();
    ShapeTextures result{gl::Texture(width, height, isCreased ? GL_RG32F : GL_R32F),
                         gl::Texture(width, height, GL_RG32F)};
    result.distances.upload(isCreased ? creasedTexels(shape) : distanceTexels(shape),
                            isCreased ? 2 : 1);
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
