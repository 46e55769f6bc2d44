#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "materials/relief_material.h"

namespace relievo::materials {

/// A box along the axes of the world around what is drawn.
struct WorldBounds {
    glm::vec3 minimum{0.0f};
    glm::vec3 maximum{0.0f};
};

/// From where something is drawn.
struct DrawnView {
    glm::mat4 viewProjection{1.0f};
    glm::vec2 pixels{1.0f};  ///< size of the viewport
};

/// By how many pixels, at most, a point in `bounds` moves in the picture when it is moved by
/// `length` world units in any direction. Infinite where the box reaches the plane of the eye.
/// Points outside the picture do not count.
double greatestShift(const WorldBounds& bounds, const DrawnView& view, double length);

/// The technique for one draw of a relief with `auto`, whose tiles are at most `tileWidth` world
/// units wide: `middleTechnique` when no point of the relief can appear out of place by more than
/// the material's `pixel-error` on the plane halfway through it, so that the program has no search
/// and its maps are not needed, and `auto` itself otherwise. Both show the same there, and `auto`
/// turns into the plane before: the change cannot be seen. Any other technique is left as it is.
const Technique& techniqueForDraw(const ReliefMaterial& material, const WorldBounds& bounds,
                                  const DrawnView& view, double tileWidth);

}  // namespace relievo::materials
