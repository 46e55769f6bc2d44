#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/report_table.h"

namespace relievo::bench {

/// A kind of map and the search that goes with it.
struct SearchKind {
    std::string_view name;
    std::string_view description;
};

/// In the order of the report.
std::span<const SearchKind> searchKinds();

/// What to measure: every kind on every sample relief, repeated without end, under rays from every
/// elevation that begin anywhere in the tile and go in all directions.
struct SearchBenchmarkOptions {
    std::vector<std::string> samples;              ///< names of textures::sampleReliefs
    std::vector<std::string> searches;             ///< names of searchKinds
    std::vector<double> elevations{45, 15, 5, 1};  ///< degrees above the surface
    int size = 256;                                ///< the reliefs are size×size texels
    int rays = 4000;                               ///< for each row of the report
    std::uint64_t seed = 1;
    double depthScale = 0.1;  ///< depth of the reliefs in tile widths
};

struct SearchMeasurement {
    std::string sample;
    std::string search;
    double elevation = 0.0;
    double meanLookups = 0.0;
    int mostLookups = 0;
    double wrongShare = 0.0;  ///< in [0,1]; see measureSearches
    /// Mean of the map's ratios (mean_ratio.h); nothing without cones.
    std::optional<double> meanRatio;
};

/// Counts lookups of searches in double precision on the CPU, and compares their hits with the
/// exact ones. A hit is wrong when it is off by over a texel along the ray, or not converged.
/// Nothing is timed: the result is the same on every machine.
std::vector<SearchMeasurement> measureSearches(const SearchBenchmarkOptions& options);

/// One row a measurement.
ReportTable searchTable(const std::vector<SearchMeasurement>& measurements);

/// Lookups against elevation: a panel a sample, a curve a search.
Plot searchPlot(const std::vector<SearchMeasurement>& measurements);

}  // namespace relievo::bench
