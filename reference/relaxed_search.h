#pragma once

#include "reference/cone_search.h"
#include "reference/map_search.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::reference {

/// Relaxed cone stepping (Policarpo, Oliveira 2007): marchByCones until a step lies below the
/// surface, then `bisections` of that step, one lookup each.
MapSearchResult searchByRelaxedCones(const textures::DepthMap& relief, const textures::Plane& ratio,
                                     const DescendingRay& ray, int bisections = 10,
                                     const SearchEnd& end = {});

/// The same with exact hits: the step that pierced is halved until what is left of it lies in one
/// bilinear cell, whose quadratic is solved (one gather). So does a ray within the tolerance of the
/// surface, from the cell that it is in on.
MapSearchResult searchByRelaxedConesAndCells(const textures::DepthMap& relief,
                                             const textures::Plane& ratio, const DescendingRay& ray,
                                             const SearchEnd& end = {});

}  // namespace relievo::reference
