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

/// The material for one draw of a surface. That is `material`, unless its technique is `auto` and
/// no point can be out of place by more than its `pixel-error` on the plane halfway through the
/// relief: then it is that plane (middleTechnique), so that the program has no search and needs
/// none of its maps; but not where light rays are searched for shadows. `auto` itself shows the
/// same there, and turns into the plane before: the change cannot be seen.
ReliefMaterial materialForDraw(const ReliefMaterial& material,
                               const surfaces::SurfaceExtent& extent, const DrawnView& view);

}  // namespace relievo::materials
