#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "outlines/outline.h"
#include "textures/wrap_mode.h"
#include "viewer/scene_file.h"

namespace relievo::viewer {

/// What a plane shape is bounded by, merged and cut to the tiles that are asked for: no vertex is
/// on a straight line between its neighbours.
struct ShapeBoundary {
    std::vector<outlines::Contour> contours;  ///< tile widths
    std::size_t vertices = 0;
    std::size_t holes = 0;
    /// Contours that are no holes.
    [[nodiscard]] std::size_t pieces() const noexcept { return contours.size() - holes; }
};

/// The boundary of a drawing in the tiles [0,tiles.x] × [0,tiles.y] under the wrap mode; under
/// clamp in its own tile alone. Coordinates are rounded to 2⁻²⁸ tile widths. A drawing that fills
/// the tiles has their rectangle.
ShapeBoundary boundaryOf(const outlines::Drawing& drawing, const glm::dvec2& tiles,
                         textures::WrapMode wrap);

/// Triangles of the mesh of an extrusion without offsets: both caps, of vertices + 2·holes −
/// 2·pieces triangles each, and two triangles for each vertex and chord of the profile.
std::size_t extrusionTriangles(const ShapeBoundary& boundary, std::size_t profileChords);

/// Triangles of the mesh of a section turned around its left border x = 0 in `sectors` steps: for
/// every edge two a sector, one where an end of it is on the axis, none where both are.
std::size_t revolutionTriangles(const ShapeBoundary& section, std::size_t sectors);

/// The fewest steps, at least 3, in which the chords of a circle of that radius are within
/// `tolerance` of it; both in the same unit, > 0.
std::size_t circleSectors(double radius, double tolerance);

/// Into how many straight pieces a profile can be taken together from its top to its bottom so that
/// none of its knots is further than `tolerance` from the piece over it; level steps count as
/// pieces. Offsets count `tileWidth` and the whole depth `depth`, all three in the same unit.
std::size_t profileChords(const solids::Profile& profile, double tileWidth, double depth,
                          double tolerance);

/// The chord tolerance of the counts, as a share of the diagonal of the box.
inline constexpr double kTessellationTolerance = 1.0 / 2000.0;

/// Triangles of a mesh of one part of a box at that tolerance, in all its tiles. Outlines are
/// flattened by `outlines` and taken without the offsets of profile and extension. Nothing for a
/// part whose shape is a baked map. Throws textures::InputError as readShapeDrawing does.
std::optional<std::size_t> partTriangles(const SceneBox& box, const ScenePart& part,
                                         const SceneShape& shape);

/// The triangles of a scene, all copies counted.
struct SceneTriangles {
    std::size_t boxes = 0;  ///< copies of boxes
    std::size_t drawn = 0;  ///< 12 a box
    /// Of meshes of the parts: the sum without the edges along which Booleans cut, which makes it a
    /// lower estimate of what a mesh of the whole takes.
    std::size_t tessellated = 0;
    std::size_t uncounted = 0;  ///< parts of baked maps, copies counted
};

/// Counts; opens the drawings and fonts of the shapes. Throws as partTriangles does.
SceneTriangles countTriangles(const SceneFile& scene);

}  // namespace relievo::viewer
