#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "materials/relief_material.h"
#include "surfaces/surface_mesh.h"

namespace relievo::materials {

/// From where something is drawn.
struct DrawnView {
    glm::mat4 viewProjection{1.0f};
    glm::vec2 pixels{1.0f};  ///< size of the viewport
};

/// By how many pixels, at most, a point of a surface moves in the picture when it is moved by
/// `length` world units in any direction. Infinite where the surface may reach the plane of the
/// eye. Points outside the picture do not count.
double greatestShift(const surfaces::SurfaceExtent& extent, const DrawnView& view, double length);

/// The material for one draw of a surface, which is `material` unless its technique is `auto`:
/// - When no point can be out of place by more than its `pixel-error` on the plane halfway through
///   the relief, it is that plane (middleTechnique), so that the program has no search and needs
///   none of its maps. `auto` itself shows the same there, and turns into the plane before: the
///   change cannot be seen.
/// - When it casts light rays for its shadow it is `exact`: they begin on the relief itself, and a
///   shadow may be much longer than the relief is deep.
ReliefMaterial materialForDraw(const ReliefMaterial& material,
                               const surfaces::SurfaceExtent& extent, const DrawnView& view);

}  // namespace relievo::materials
