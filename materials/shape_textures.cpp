#include "materials/shape_textures.h"

#include <algorithm>
#include <vector>

#include "materials/relief_maps.h"

namespace relievo::materials {
namespace {

ShapeTextures upload(const textures::ShapeMap& shape, bool isSection) {
    const GLenum wrap = isSection ? GL_CLAMP_TO_EDGE : glWrapMode(shape.wrap);
    const int width = shape.width();
    const int height = shape.height();
    ShapeTextures result{gl::Texture(width, height, GL_R32F), gl::Texture(width, height, GL_RG32F)};
    std::vector<float> texels(shape.distance.texels);
    for (float& texel : texels)
        texel *= static_cast<float>(width);
    result.distances.upload(texels, 1);
    result.distances.setSampling(wrap, GL_NEAREST);
    texels.resize(2 * shape.gradientX.texels.size());
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
                                            bool isSection) {
    const Key key(shape, isSection);
    const auto found = textures_.find(key);
    if (found != textures_.end())
        return found->second;
    return textures_.emplace(key, upload(*shape, isSection)).first->second;
}

}  // namespace relievo::materials
