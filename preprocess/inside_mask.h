#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/plane_shape.h"

namespace relievo::preprocess {

/// For width × height texels, row by row, whether the centre of each is inside the shape: 1 or 0.
/// Where a row of centres crosses the edges is sorted once a row.
std::vector<std::uint8_t> insideMask(const PlaneShape& shape, int width, int height);

}  // namespace relievo::preprocess
