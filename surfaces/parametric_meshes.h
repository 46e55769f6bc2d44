#pragma once

#include "surfaces/surface_mesh.h"

namespace relievo::surfaces {

/// How many rectangles a curved surface is divided into, along u and along v.
struct Divisions {
    int columns;
    int rows;
};

/// Half the width of the sphere; the whole is as wide as quad and box.
inline constexpr float kSphereRadius = 0.5f;
/// The circle in the middle of the torus' tube, and the tube: together as wide as quad and box.
inline constexpr float kTorusRadius = 0.35f;
inline constexpr float kTubeRadius = 0.15f;

/// A sphere of radius ½ round the origin. u goes round the z axis, counter-clockwise seen from
/// above and from +x on; v from the upper pole to the lower one. Frames and normals are those of
/// the sphere itself, so that tiles get as narrow as it does towards the poles, and the relief as
/// flat. Along the equator texels of a map of aspect ρ are square where 2ρ·tiles.y = tiles.x. The
/// window has no borders. At least 3 columns and 2 rows.
SurfaceMesh makeSphere(Tiles tiles, Divisions divisions = {64, 32});

/// A torus round the z axis, 1 wide. u goes round the ring as on the sphere; v round the tube, from
/// the inside over the top, so that the seam is inside. The window has no borders. At least 3
/// columns and 3 rows.
SurfaceMesh makeTorus(Tiles tiles, Divisions divisions = {96, 32});

}  // namespace relievo::surfaces
