#pragma once

#include <cstddef>
#include <vector>

#include "preprocess/coverage_outline.h"
#include "preprocess/texel_sides.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Puts back the corners of a chain that traceCoverage cuts off: where two straight pieces of sure
/// points meet at 40° or more a few texels further on, the points between give way to the point
/// where they meet; if the two half planes explain the coverage of every texel around, each within
/// 0.08. What they leave over in all, as where one side is curved, moves the point along the
/// straighter side. Nothing else may lie there then, so that no chain crosses another afterwards.
///
/// Under mirror that holds for corners on the border as well; under clamp chains go straight on to
/// it.
///
/// `sides` are those of the chain, under its wrap mode. The texels that change theirs are appended
/// to `changed`.
void sharpenCorners(const textures::Plane& coverage, const TexelSides& sides, OutlineChain& chain,
                    std::vector<std::size_t>& changed);

}  // namespace relievo::preprocess
