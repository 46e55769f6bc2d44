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
    int repeat = 3;   ///< runs, of which the fastest counts
    int threads = 0;  ///< at most so many; 0 is one for each core
};

struct BakeMeasurement {
    std::string sample;
    std::string builder;
    int size = 0;
    double seconds = 0.0;  ///< of the fastest run
    /// Of a cone search, for each texel of the map: nodes and samples that were tried for a packet
    /// of apexes. The same on every machine.
    std::optional<double> nodesPerTexel;
    std::optional<double> samplesPerTexel;
    /// Of cones: the mean ratio, those above 1 counted as 1.
    std::optional<double> meanRatio;
    /// Of distances that may be wrong: how many are, and the greatest error in texels.
    std::optional<std::int64_t> wrongTexels;
    std::optional<double> greatestError;

    [[nodiscard]] double nanosecondsPerTexel() const noexcept {
        return 1e9 * seconds / (static_cast<double>(size) * size);
    }
};

/// Measures, sample by sample, builder by builder, in the order of the options. The reliefs are
/// generated, and the input of a builder that starts from another map is built, outside the time.
/// Builders that this program lacks, and sizes that would take a builder too long, are left out
/// with a note.
std::vector<BakeMeasurement> measureBake(const BakeBenchmarkOptions& options);

/// The number of threads that `options` allow on this machine.
int allowedThreads(const BakeBenchmarkOptions& options);

/// One row a measurement.
ReportTable bakeTable(const std::vector<BakeMeasurement>& measurements);

/// Time per texel against size: a panel a builder, a curve a sample.
Plot bakePlot(const std::vector<BakeMeasurement>& measurements);

}  // namespace relievo::bench
