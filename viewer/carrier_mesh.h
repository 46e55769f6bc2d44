#pragma once

#include <glm/vec4.hpp>

#include "surfaces/surface_mesh.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// The mesh that carries the relief or the solid of `options`, other than a shape box: one unit
/// wide, with options.tiles of a map of aspect ρ across it, or across each tile of a file's own uv.
/// Throws textures::InputError for a file that cannot be read or has no uv.
surfaces::SurfaceMesh makeCarrier(const ViewOptions& options, float aspect);

/// Whether the relief goes on over all of (u,v), as its map is wrapped; on a quad and on the faces
/// of a box it ends at the borders.
bool isWithoutBorders(ObjectKind object);

/// The window of makeCarrier's mesh: minimum u, v, maximum u, v.
glm::vec4 carrierWindow(const ViewOptions& options);

}  // namespace relievo::viewer
