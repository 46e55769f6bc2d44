#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "gl/texture.h"
#include "textures/shape_map.h"

namespace relievo::materials {

/// A shape on the GPU.
struct ShapeTextures {
    /// Looked up four at a time, in texels: R32F, the distance to the outline; with creases RG32F,
    /// around corners with marks in its last bits (RELIEVO_SOLID_MARK_BITS), and codes. The marks
    /// make such a distance less by 2⁻¹⁶ of itself at most.
    gl::Texture distances;
    gl::Texture gradients;  ///< RG32F, unit gradients of the distance, linear
};

/// The shapes of a renderer on the GPU, each uploaded once, when it is first asked for. Needs a
/// current context for its whole life.
class ShapeTextureCache {
  public:
    /// `isSection`: the shape is that of a revolution, which is read clamped whatever its wrap
    /// mode. `isCreased`: with its creases, if it has any; else its distances alone. The cache
    /// keeps the shape.
    const ShapeTextures& get(const std::shared_ptr<const textures::ShapeMap>& shape, bool isSection,
                             bool isCreased);

    [[nodiscard]] std::size_t size() const noexcept { return textures_.size(); }

  private:
    using Key = std::tuple<std::shared_ptr<const textures::ShapeMap>, bool, bool>;
    std::map<Key, ShapeTextures> textures_;
};

}  // namespace relievo::materials
