#pragma once

#include <optional>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Points of the bilinear surface every `step` texels, at most `reachX` and `reachY` texels from an
/// apex.
struct SurfacePoints {
    double reachX;
    double reachY;
    double step;
};

/// Which chords limit a cone: all of them (conservative), or with a tolerance those to points where
/// the depth grows along the chord just after its end (relaxed). Growth within that share of the
/// growth along both axes counts as none; a negative tolerance counts such growth, too.
using CrestTolerance = std::optional<double>;

/// Sector `number` of 1, 4 or 8 (reference/ray_sector.h), its borders included.
struct SampledSector {
    int number = 0;
    int sectors = 1;
    /// Of a step of so many texel widths along each axis.
    [[nodiscard]] bool has(double dx, double dy) const;
};

/// The steepest chord of the bilinear surface, in depth per texel width, from (x,y) down to points
/// that are higher, along the directions of a sector; 0 without any. Coordinates in texels: (i,j)
/// is the centre of that texel.
double steepestChord(const textures::DepthMap& map, double x, double y, const SurfacePoints& points,
                     CrestTolerance crests = {}, const SampledSector& sector = {});

/// The ratio in tile widths of a cone as steep as that chord; +infinity for 0.
double ratioOfSlope(const textures::DepthMap& map, double slope);

/// How densely cones are sampled that hold for all of a texel's square.
struct ConeSampling {
    int apexes;    ///< on a side of the square
    double reach;  ///< of the far points, in texels
    CrestTolerance crests;
    SampledSector sector = {};
};

/// As many apexes as a test of many texels has time for, and all that is near enough to count.
ConeSampling conservativeSampling(const textures::DepthMap& map);
ConeSampling relaxedSampling(const textures::DepthMap& map);

/// The widest cone that holds for the sampled apexes in the square of texel (i,j) and for points
/// every eighth of a texel around them and every texel farther away: no wider one is safe.
double sampledRatio(const textures::DepthMap& map, int i, int j, const ConeSampling& sampling);

/// Cones compared with sampled ones: sums of ratios, those above 1 counted as 1, and how many are
/// wider than they may be.
struct Tightness {
    double built = 0.0;
    double sampled = 0.0;
    int tooWide = 0;
};

/// The comparison at `texels` random texels.
Tightness compareWithSamples(const textures::DepthMap& map, const textures::Plane& ratio,
                             const ConeSampling& sampling, int texels, unsigned seed);

}  // namespace relievo::preprocess
