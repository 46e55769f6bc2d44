#pragma once

#include <span>

#include "textures/plane.h"

namespace relievo::preprocess {

/// The share of the light of an even sky that reaches each texel of a relief, 1 where nothing
/// stands in its way: of a level patch of surface, which weighs directions by the cosine to the
/// vertical. `horizons` are those of evenly spread azimuths (horizon_map.h), one at least; depth
/// scale `depthScale` ≥ 0 in tile widths.
///
/// Over a sector of azimuths with the horizon at elevation α that share is cos²α = 1/(1 + tan²α)
/// in closed form, and tan α is depthScale·horizon.
textures::Plane buildOcclusion(std::span<const textures::Plane* const> horizons, double depthScale);

}  // namespace relievo::preprocess
