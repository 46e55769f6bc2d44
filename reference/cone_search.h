#pragma once

#include "reference/map_search.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::reference {

/// When a search that only comes closer and closer ends.
struct SearchEnd {
    double tolerance = 1e-4;  ///< closer than this above the surface, in depth, is a hit
    int mostSteps = 1000;     ///< not converged after so many
};

/// How far cone stepping came.
struct ConeMarch {
    double before = 0.0;  ///< depth of the ray one step earlier
    double z = 0.0;
    double gap = 0.0;  ///< D − z there: under the tolerance, negative when the last step pierced
    bool converged = true;
    int lookups = 0;
};

/// Cone stepping (specification 3.1): from (P,z), with the depth D at P (GL_LINEAR) and the ratio c
/// of the texel that holds P (GL_NEAREST), two lookups, on by c·(D−z)/(s+c), until D−z is under the
/// tolerance.
ConeMarch marchByCones(const textures::DepthMap& relief, const textures::Plane& ratio,
                       const DescendingRay& ray, const SearchEnd& end);

/// The search that takes the end of marchByCones for the hit.
MapSearchResult searchByCones(const textures::DepthMap& relief, const textures::Plane& ratio,
                              const DescendingRay& ray, const SearchEnd& end = {});

/// Cone stepping with exact hits: one gather gives the bilinear cell at P, whose quadratic is
/// solved first; a ray that does not hit there goes on to the cell's exit, or with a second lookup
/// to the end of the cone if that is farther.
MapSearchResult searchByConesAndCells(const textures::DepthMap& relief,
                                      const textures::Plane& ratio, const DescendingRay& ray);

}  // namespace relievo::reference
