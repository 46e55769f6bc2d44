#pragma once

#include <vector>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::materials {

/// Second moments of the slopes (dx, dy) of a relief over the texels of one of its MIP levels:
/// means of dx², dx·dy and dy². Slopes are those of preprocess::Derivatives.
struct SlopeMoments {
    textures::Plane xx;
    textures::Plane xy;
    textures::Plane yy;
};

/// The moments of `relief` for its second MIP level and all after it, each half as large as the one
/// before, down to 1×1; none for a relief of one texel. They are moments of the slopes that shading
/// sees, interpolated between the texels of the first level, which vary less than those of the
/// texels.
///
/// Moments, unlike normals, can be filtered (Olano, Baker, LEAN mapping, 2010): what a level has
/// averaged away is what they are more than the products of its own slopes.
std::vector<SlopeMoments> slopeMoments(const textures::DepthMap& relief);

}  // namespace relievo::materials
