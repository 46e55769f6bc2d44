#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace relievo::viewer {

/// An axis of a box. World space is right-handed with z up.
enum class BoxAxis { X, Y, Z };

/// The space of the whole of a shape box is the cube (u,v,z) in [0,1]³ as solids::Compound has it:
/// v and z grow downwards in the picture and into the depth, so both are flipped against the box's
/// own axes. In a box of edges S around its own origin
///
///     x = (u − ½)·S.x      y = (½ − v)·S.y      z_local = (½ − z)·S.z
///
/// `size` is S in world units, > 0.
glm::dmat4 wholeToLocal(const glm::dvec3& size);

/// The placement of a box: turned by `degrees` about its own x, then the world's y, then its z, and
/// moved to `position`.
glm::dmat4 localToWorld(const glm::dvec3& position, const glm::dvec3& degrees);

/// The part of a box that a solid fills.
struct PartPlace {
    /// Corners in the box's own axes, around the box's centre; may reach out of the box, which cuts
    /// off what is outside.
    glm::dvec3 minimum{-0.5};
    glm::dvec3 maximum{0.5};
    /// The line of the part's depth, and with it the side that its picture faces; u is always to
    /// the right in the picture, v downwards, the depth into it:
    ///
    ///     Z   seen from above    u along +x   v along −y   depth along −z
    ///     Y   seen from −y       u along +x   v along −z   depth along +y
    ///     X   seen from +x       u along +y   v along −z   depth along −x
    BoxAxis along = BoxAxis::Z;
    glm::dvec3 tiles{1.0};  ///< of u, v and the depth, in the place; > 0
};

/// From the space of the whole of a box with edges `size` to the tile space of a part that has
/// `place.tiles` tiles in its place: what solids::SolidPart::fromWhole takes.
glm::dmat4 wholeToPart(const glm::dvec3& size, const PartPlace& place);

/// How long a tile of the part is along its u, v and depth, in world units.
glm::dvec3 tileLengths(const PartPlace& place);

}  // namespace relievo::viewer
