#pragma once

#include "textures/sample_surface.h"

namespace relievo::textures {

/// Rows of the word RELIEVO, raised and bevelled, with bars between them, on a rough plate.
SampleSurface letteringSurface(double u, double v, const SampleTile& tile);

}  // namespace relievo::textures
