#pragma once

#include <cstddef>
#include <functional>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Relaxed cones by rays from every texel to every other one (Policarpo and Oliveira 2007,
/// algorithm 3.3 of the thesis with erratum E6). The ray from the reference surface above the apex
/// t through the surface at texel y is followed beyond y while it is inside the relief, in `steps`
/// ≥ 1 equal steps down to the bottom, or steps of a texel where those are longer. Where it leaves
/// the relief, at a point p above the apex, the cone may not hold p:
///
///   c(t) = min over y of |t − p| / (D(t) − depth of p)
///
/// Repeat takes the nearest copy of each y; mirror and clamp take the one of the tile.
///
/// A baseline for small maps, quadratic and worse, and **not safe**: a ray that grazes leaves the
/// relief past bumps that the rays from the reference surface do not see (specification 3.3), and
/// steps find where a ray leaves up to a step late.
///
/// Units, rounding, unlimited cones and `advance` are those of buildConservativeCones.
textures::Plane buildRelaxedConesByRays(const textures::DepthMap& map,
                                        const std::function<void(std::size_t)>& advance = {});

}  // namespace relievo::preprocess
