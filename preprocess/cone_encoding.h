#pragma once

#include "textures/map_set.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The channel `cone` of a map file from ratios (tile widths per unit of depth, +infinity where
/// unlimited) over the depths that the file stores: the ratios themselves, or the radii of the
/// cones at the reference surface, ratio·D, rounded down. The unlimited ratio of a texel of depth 0
/// is an unlimited radius.
textures::Plane encodeCones(const textures::Plane& ratio, const textures::Plane& depth,
                            textures::ConeEncoding encoding);

/// encodeCones without a second plane: turns ratios into the channel `cone`.
void encodeConesInPlace(textures::Plane& cone, const textures::Plane& depth,
                        textures::ConeEncoding encoding);

/// The ratios of a channel `cone`, rounded down: the inverse of encodeCones up to rounding. The
/// radius of a texel of depth 0 says nothing and gives an unlimited ratio.
textures::Plane decodeCones(const textures::Plane& cone, const textures::Plane& depth,
                            textures::ConeEncoding encoding);

}  // namespace relievo::preprocess
