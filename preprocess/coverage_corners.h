#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/coverage_outline.h"
#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// Puts back the corners that traceCoverage cuts off: where two straight pieces of sure points meet
/// at 40° or more a few texels further on, the points between give way to the point where they
/// meet; if the two half planes explain the coverage of every texel around, each within 0.08.
/// Nothing else may lie there then, so that no chain crosses another afterwards.
///
/// `inside` has for each texel, row by row, whether its centre is inside the chains: 1 or 0; it is
/// kept up to date.
void sharpenCorners(const textures::Plane& coverage, textures::WrapMode wrap,
                    std::vector<OutlineChain>& chains, std::vector<std::uint8_t>& inside);

}  // namespace relievo::preprocess
