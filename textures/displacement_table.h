#pragma once

#include <vector>

#include "textures/map_set.h"

namespace relievo::textures {

/// A table of view-dependent displacements over a plane base (the map `vdm` of relievo-bake) as a
/// sum of products: a ray of azimuth a and elevation e that enters a tile at a texel hits the
/// relief at the normalised depth Σₖ factors[k·azimuths + a] · weights[e][k]. A table that is not
/// packed has a term for each elevation, of weight 0 in all others.
///
/// Depths are what is tabulated here, and not distances along the ray as in the file, because
/// between two elevations they change less: over a level relief they are all the same.
struct DisplacementTable {
    int azimuths = 0;  ///< of the way that the ray goes: azimuth a is 2π·a/azimuths, from +u to +v
    /// Of the map set, which must outlive this.
    std::vector<const Plane*> factors;
    /// Elevations from the lowest, 90°/n, to the n-th, 90°, at `relievo:vdm-scale`.
    std::vector<std::vector<float>> weights;

    [[nodiscard]] std::size_t terms() const noexcept {
        return weights.empty() ? 0 : weights.front().size();
    }
};

/// The table in `maps`: `vdmfactor0` … with `relievo:vdm-weights`, or `vdm0` …, and in both cases
/// `relievo:vdm-views` and `relievo:vdm-scale`; no terms when `maps` has neither. Throws
/// InputError, without a file name, that says which of them is missing or wrong.
DisplacementTable displacementTableOf(const MapSet& maps);

}  // namespace relievo::textures
