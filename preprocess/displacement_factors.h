#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "preprocess/view_grid.h"
#include "textures/plane.h"
#include "textures/storage_format.h"

namespace relievo::preprocess {

/// A table of view-dependent displacements as a sum of few products, packed as Wang et al. 2003 do:
/// the distance of a texel p in the view of azimuth φ, elevation e and curvature κ, where it hits,
/// is Σₖ factor k (p,φ) · weight k (e,κ). A lookup takes one texel a term.
struct DisplacementFactors {
    /// For each azimuth and each curvature above 0, in the order of missesPlane, the number of
    /// elevations that have no hit: the lowest ones, for a ray that misses is above all lower ones.
    std::vector<textures::Plane> misses;
    /// For each term, the most important first, a plane for each azimuth; values from −1 to 1.
    std::vector<textures::Plane> factors;
    /// For each term a weight for each elevation and curvature, in tile widths, in the order of the
    /// views of one azimuth.
    std::vector<std::vector<float>> weights;
};

/// The planes of DisplacementFactors::misses.
std::size_t missesPlanes(const ViewGrid& grid);
/// Which of them is that of an azimuth and of a curvature above 0.
std::size_t missesPlane(const ViewGrid& grid, int azimuth, int curvature);

/// The factors of a table (view_displacement.h), as `format` will store them: `terms` ≥ 1, of which
/// those beyond the number of elevations and curvatures are 0. What has no hit takes the distance
/// of the next steeper view that has one, here and in `table`, so that the sum need not follow
/// silhouettes; `misses` keeps them exactly.
///
/// The terms are the singular vectors of the table with a row for each texel and azimuth and a
/// column for each elevation and curvature: no other sum of as many products is nearer in squares
/// (Eckart and Young 1936). They come from the products of columns with each other, so the time is
/// O(size of the table · (terms + elevations·curvatures)). Scratch memory: some rows of texels.
/// `advance` is called from any thread with numbers that add up to factorSteps().
DisplacementFactors factorDisplacement(std::vector<textures::Plane>& table, const ViewGrid& grid,
                                       int terms, textures::StorageFormat format,
                                       const std::function<void(std::size_t)>& advance = {});

/// The work of factorDisplacement: columns of the table that are gone through.
std::size_t factorSteps(const ViewGrid& grid, int terms);

/// The distance of a view that hits at `texel`, from the factors.
double displacementOf(const DisplacementFactors& factors, const ViewGrid& grid, std::size_t view,
                      std::size_t texel);

}  // namespace relievo::preprocess
