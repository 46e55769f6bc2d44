#pragma once

#include <cstddef>
#include <functional>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The cones of buildConservativeCones by the search in growing squares (Dummer 2006, algorithm 3.2
/// of the thesis): texels in squares around each apex, from the inside out, until no texel further
/// out can have a smaller ratio. That is once radius/D(t) reaches the best ratio, because no texel
/// is higher than the apex by more than D(t) (erratum E5; the printed stop comes too early). Exact,
/// and quadratic where cones are wide: a baseline for small maps.
///
/// Units, rounding, unlimited cones and `advance` are those of buildConservativeCones.
///
/// With a `step` above 1 only every step-th texel of every step-th row is built, from the first on,
/// and the result has no more texels than that: a sample, of maps that would take too long.
textures::Plane buildConesBySquares(const textures::DepthMap& map,
                                    const std::function<void(std::size_t)>& advance = {},
                                    int step = 1);

}  // namespace relievo::preprocess
