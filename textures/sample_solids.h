#pragma once

#include "textures/sample_surface.h"

namespace relievo::textures {

/// Few, thin, high round pillars on a nearly flat floor.
SampleSurface pillarSurface(double u, double v, const SampleTile& tile);

/// Sharp cones of different heights, close together.
SampleSurface spikeSurface(double u, double v, const SampleTile& tile);

/// Half balls in staggered rows on a flat floor.
SampleSurface hemisphereSurface(double u, double v, const SampleTile& tile);

}  // namespace relievo::textures
