#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/report_table.h"
#include "textures/depth_map.h"

namespace relievo::bench {

/// A map builder that can be measured.
struct BakeBuilder {
    std::string_view name;
    std::string_view description;
};

/// derivatives, normals, cones-exact, cones-levels.
std::span<const BakeBuilder> bakeBuilders();

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
    /// Pyramid nodes that the cone search looked at, per texel: the same on every machine.
    std::optional<double> nodesPerTexel;

    [[nodiscard]] double nanosecondsPerTexel() const noexcept {
        return 1e9 * seconds / (static_cast<double>(size) * size);
    }
};

/// Measures, sample by sample, builder by builder, in the order of the options. The reliefs are
/// generated, and the input of a builder that starts from another map is built, outside the time.
std::vector<BakeMeasurement> measureBake(const BakeBenchmarkOptions& options);

/// The number of threads that `options` allow on this machine.
int allowedThreads(const BakeBenchmarkOptions& options);

/// One row a measurement.
ReportTable bakeTable(const std::vector<BakeMeasurement>& measurements);

/// Time per texel against size: a panel a builder, a curve a sample.
Plot bakePlot(const std::vector<BakeMeasurement>& measurements);

}  // namespace relievo::bench
