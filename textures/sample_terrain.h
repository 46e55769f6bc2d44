#pragma once

#include "textures/sample_surface.h"

namespace relievo::textures {

/// Fractal noise: rugged ground.
SampleSurface noiseSurface(double u, double v, const SampleTile& tile);

/// One long smooth ridge along u whose crest rises and falls: it has one summit, but is crossed
/// everywhere (the case that local maxima miss).
SampleSurface ridgeSurface(double u, double v, const SampleTile& tile);

/// waveDepth as a sample.
SampleSurface waveSurface(double u, double v, const SampleTile& tile);

}  // namespace relievo::textures
