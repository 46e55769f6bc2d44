#pragma once

#include "preprocess/derivatives.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Unit normals in tangent space: x along u, y along v, z up out of the surface.
struct Normals {
    textures::Plane nx;
    textures::Plane ny;
    textures::Plane nz;
};

/// The normals of the relief whose depth of 1 is `depthScale` (a0 ≥ 0) tile widths:
/// normalize(a0·dx, a0·dy, 1). The signs are those of a depth map; a height map has the opposite.
/// Another scale a is had at run time by normalize((a/a0)·nx, (a/a0)·ny, nz).
Normals buildNormals(const Derivatives& derivatives, double depthScale);

}  // namespace relievo::preprocess
