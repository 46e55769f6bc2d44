#pragma once

#include "textures/sample_surface.h"

namespace relievo::textures {

/// Bricks in running bond, with worn edges and a little uneven, over deeper mortar.
SampleSurface brickSurface(double u, double v, const SampleTile& tile);

/// Rounded stones of irregular outline (a Voronoi pattern) with even joints.
SampleSurface cobbleSurface(double u, double v, const SampleTile& tile);

/// Square plateaus of three sizes and many heights, with vertical walls.
SampleSurface blockSurface(double u, double v, const SampleTile& tile);

}  // namespace relievo::textures
