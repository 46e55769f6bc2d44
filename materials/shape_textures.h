#pragma once

#include <map>
#include <memory>
#include <utility>

#include "gl/texture.h"
#include "textures/shape_map.h"

namespace relievo::materials {

/// A shape on the GPU.
struct ShapeTextures {
    gl::Texture distances;  ///< R32F, texels from the outline, looked up four at a time
    gl::Texture gradients;  ///< RG32F, unit gradients of the distance, linear
};

/// The shapes of a renderer on the GPU, each uploaded once, when it is first asked for. Needs a
/// current context for its whole life.
class ShapeTextureCache {
  public:
    /// `isSection`: the shape is that of a revolution, which is read clamped whatever its wrap
    /// mode. The cache keeps the shape.
    const ShapeTextures& get(const std::shared_ptr<const textures::ShapeMap>& shape,
                             bool isSection);

    [[nodiscard]] std::size_t size() const noexcept { return textures_.size(); }

  private:
    using Key = std::pair<std::shared_ptr<const textures::ShapeMap>, bool>;
    std::map<Key, ShapeTextures> textures_;
};

}  // namespace relievo::materials
