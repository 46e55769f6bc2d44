#pragma once

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The least and greatest depths around each texel: what is left when every column of the relief is
/// widened (dilation of heights) and when every hole is (erosion).
struct DepthExtrema {
    textures::Plane least;     ///< channel `dmin`
    textures::Plane greatest;  ///< channel `dmax`
};

/// Extrema over the (2·reach+1)² texels around each texel, `reach` ≥ 0, under the map's wrap mode.
/// The bilinear surface lies between them everywhere within `reach` texels along both axes of a
/// texel centre, for samples bound the patches between them. For safe-zone searches (Kolb and
/// Rezk-Salama 2005).
///
/// Linear time, whatever the reach: rows, then columns in stripes, each with three comparisons a
/// texel (van Herk 1992, Gil and Werman 1993). Scratch memory: 768 bytes for each of
/// height + 2·reach rows and thread.
DepthExtrema findDepthExtrema(const textures::DepthMap& map, int reach);

}  // namespace relievo::preprocess
