#pragma once

#include <vector>

#include "preprocess/displacement_factors.h"
#include "preprocess/view_grid.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// How far distances from factors are off, in tile widths, over all that have a hit.
struct DisplacementError {
    double mean = 0.0;
    double percentile99 = 0.0;  ///< 99 of 100 are off by no more, up to 1 % above
    double greatest = 0.0;
};

/// Measures it against the table from which factorDisplacement made them. The same for any number
/// of threads. Scratch memory: 0.3 MB for each curvature.
DisplacementError measureFactors(const std::vector<textures::Plane>& table, const ViewGrid& grid,
                                 const DisplacementFactors& factors);

}  // namespace relievo::preprocess
