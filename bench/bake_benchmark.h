#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/report_table.h"

namespace relievo::bench {

/// What to measure: every builder on every sample relief at every size (N×N texels).
struct BakeBenchmarkOptions {
    std::vector<std::string> samples;   ///< names of textures::sampleReliefs
    std::vector<std::string> builders;  ///< names of bakeBuilders
    std::vector<int> sizes{128, 256, 512, 1024};
    /// Runs, of which the fastest counts; fewer once they have taken two seconds together.
    int repeat = 3;
    bool hasNoLimits = false;  ///< also at sizes above what a builder is usually measured at
};

struct BakeMeasurement {
    std::string sample;
    std::string builder;
    int size = 0;
    double seconds = 0.0;          ///< of the fastest run
    std::int64_t builtTexels = 0;  ///< those of the map, or those of its sample that were built
    /// Of a cone search, for each texel of the map: nodes and samples that were tried for a packet
    /// of apexes. The same on every machine.
    std::optional<double> nodesPerTexel;
    std::optional<double> samplesPerTexel;
    /// Of cones: the mean ratio, those above 1 counted as 1.
    std::optional<double> meanRatio;
    /// The most memory from operator new besides input and result, in bytes a texel; nothing where
    /// a library has memory of its own.
    std::optional<double> workingBytes;
    /// Of distances that may be wrong: how many are, and the greatest error in texels.
    std::optional<std::int64_t> wrongTexels;
    std::optional<double> greatestError;

    [[nodiscard]] double nanosecondsPerTexel() const noexcept {
        return 1e9 * seconds / static_cast<double>(builtTexels);
    }
    [[nodiscard]] double megatexelsPerSecond() const noexcept {
        return 1e3 / nanosecondsPerTexel();
    }
};

/// Measures, sample by sample, builder by builder, in the order of the options. The reliefs are
/// generated, and the input of a builder that starts from another map is built, outside the time.
/// Builders that this program lacks, and without hasNoLimits sizes above a builder's largest, are
/// left out with a note.
std::vector<BakeMeasurement> measureBake(const BakeBenchmarkOptions& options);

/// One row a measurement.
ReportTable bakeTable(const std::vector<BakeMeasurement>& measurements);

/// Time per texel against size: a panel for each builder that was measured at several sizes, a
/// curve for each sample.
Plot bakePlot(const std::vector<BakeMeasurement>& measurements);

}  // namespace relievo::bench
