#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "solids/profile.h"
#include "textures/shape_map.h"

namespace relievo::solids {

/// What is made of a plane shape (specification 7.2, 7.3).
enum class SolidKind { Extrusion, Revolution };

/// A solid in its own tile space (u,v,z): u and v in tiles of the shape's width and height, z the
/// normalised depth downwards. With d the bilinear distance of the map:
///
/// - Extrusion: the points with d(u,v) ≤ o(z). Tiles continue as the map's wrap mode says; z is in
///   [0,1].
/// - Revolution: the shape is a section that stands upright, its left border the axis, its rows the
///   depths: the points with d(|R|, z) ≤ e, where R = (u,v) minus the axis of the tile, as long as
///   in the map's own metric: one tile of u or v is a map's width, one of z a map's height. Every
///   tile of u, v and z is a replica of its own, cut off at its borders; the section is read
///   clamped there. Under mirror every other replica along z is upside down.
struct Solid {
    std::shared_ptr<const textures::ShapeMap> shape;
    SolidKind kind = SolidKind::Extrusion;
    Profile profile = makeProfile(0.0);  ///< of an extrusion
    double extension = 0.0;              ///< e of a revolution, in tile widths
    glm::dvec2 axis{0.5};                ///< O of a revolution, in its tile
};

/// How a part joins those before it.
enum class BooleanOperation { Union, Intersection, Difference };

/// A solid within a box of its own tile space, placed in the space of the whole.
struct SolidPart {
    Solid solid;
    /// Nothing of the solid is outside. Extrusions: z from 0 to 1 at most.
    glm::dvec3 windowMinimum{0.0};
    glm::dvec3 windowMaximum{1.0};
    /// From the space of the whole to the tile space of the part: affine and invertible.
    glm::dmat4 fromWhole{1.0};
    BooleanOperation operation = BooleanOperation::Union;  ///< of the first part: Union
};

/// Parts joined one after the other: ((first ∘ second) ∘ third) …
struct Compound {
    std::vector<SolidPart> parts;
};

/// Parts that shaders have room for.
inline constexpr int kMostParts = 4;

}  // namespace relievo::solids
