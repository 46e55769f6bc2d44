#include "bench/bake_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "bench/allocated_memory.h"
#include "bench/bake_builders.h"
#include "bench/mean_ratio.h"
#include "bench/stopwatch.h"
#include "commands/program.h"
#include "commands/progress.h"
#include "preprocess/sequential_distances.h"
#include "textures/sample_reliefs.h"

namespace relievo::bench {

namespace {

bool exceeds(const BakeBuilder& builder, int size, const BakeBenchmarkOptions& options) {
    return !options.hasNoLimits && builder.largestSize > 0 && size > builder.largestSize;
}

constexpr double kEnoughSeconds = 2.0;

// Runs `builder` `repeat` times, or until there is enough to go by, and keeps the last result.
BakeOutput run(const BakeBuilder& builder, const BakeInput& input, int repeat,
               BakeMeasurement& measurement) {
    BakeOutput output;
    double total = 0.0;
    measurement.seconds = std::numeric_limits<double>::infinity();
    for (int k = 0; k < repeat && total < kEnoughSeconds; ++k) {
        output = {};
        forgetMostAllocatedBytes();
        const double seconds = secondsOf([&] { output = builder.build(input); });
        total += seconds;
        measurement.seconds = std::min(measurement.seconds, seconds);
    }
    // What is allocated now is input and result.
    if (output.ratios || output.doubtfulDistances || output.others.has_value())
        measurement.workingBytes = static_cast<double>(mostAllocatedBytes() - allocatedBytes()) /
                                   static_cast<double>(input.map.depth.texels.size());
    return output;
}

// Runs `builder` and takes what it says of its work, per texel that it built. Checking distances is
// not part of the time.
BakeMeasurement measure(const BakeBuilder& builder, const BakeInput& input, int repeat) {
    BakeMeasurement measurement;
    measurement.builder = builder.name;
    const BakeOutput output = run(builder, input, repeat, measurement);
    measurement.builtTexels =
        static_cast<std::int64_t>((output.ratios ? *output.ratios : input.map.depth).texels.size());
    const auto texels = static_cast<double>(measurement.builtTexels);
    if (output.search) {
        measurement.nodesPerTexel = static_cast<double>(output.search->nodes) / texels;
        measurement.samplesPerTexel = static_cast<double>(output.search->samples) / texels;
    }
    if (output.ratios)
        measurement.meanRatio = meanRatio(*output.ratios);
    if (output.doubtfulDistances) {
        const preprocess::DistanceErrors errors = preprocess::compareDistances(
            *output.doubtfulDistances, preprocess::distancesTo(input.raised, input.map.width(),
                                                               input.map.height(), input.map.wrap));
        measurement.wrongTexels = static_cast<std::int64_t>(errors.tooLarge + errors.tooSmall);
        measurement.greatestError = errors.greatest;
    }
    return measurement;
}

// Whether `builder` can be measured at all; says what is left out and why.
bool isMeasured(const BakeBuilder& builder, const BakeBenchmarkOptions& options) {
    if (!builder.build) {
        commands::note(fmt::format(
            "{} is left out: the library was not found when the program was built", builder.name));
        return false;
    }
    for (const int size : options.sizes)
        if (exceeds(builder, size, options))
            commands::note(
                fmt::format("{} is left out at {}x{}: it takes long above {}x{} "
                            "(--no-limits measures it)",
                            builder.name, size, size, builder.largestSize, builder.largestSize));
    return true;
}

template <typename Value>
ReportCell cellOf(const std::optional<Value>& value) {
    return value ? ReportCell(*value) : ReportCell();
}

}  // namespace

std::vector<BakeMeasurement> measureBake(const BakeBenchmarkOptions& options) {
    std::vector<const BakeBuilder*> builders;
    for (const std::string& name : options.builders)
        if (isMeasured(bakeBuilder(name), options))
            builders.push_back(&bakeBuilder(name));
    commands::Progress progress("maps",
                                options.samples.size() * options.sizes.size() * builders.size());
    std::vector<BakeMeasurement> measurements;
    for (const std::string& sample : options.samples)
        for (const int size : options.sizes) {
            const BakeInput input =
                makeBakeInput(textures::generateSampleRelief(sample, size, size));
            for (const BakeBuilder* builder : builders) {
                if (!exceeds(*builder, size, options)) {
                    measurements.push_back(measure(*builder, input, options.repeat));
                    measurements.back().sample = sample;
                    measurements.back().size = size;
                }
                progress.advance();
            }
        }
    return measurements;
}

ReportTable bakeTable(const std::vector<BakeMeasurement>& measurements) {
    ReportTable table;
    table.columns = {{"sample", "sample"},
                     {"builder", "builder"},
                     {"size", "size"},
                     {"milliseconds", "ms"},
                     {"nanosecondsPerTexel", "ns/texel"},
                     {"megatexelsPerSecond", "Mtexel/s"},
                     {"builtTexels", "texels"},
                     {"workingBytesPerTexel", "bytes/texel"},
                     {"nodesPerTexel", "nodes/texel"},
                     {"samplesPerTexel", "samples/texel"},
                     {"meanRatio", "mean ratio"},
                     {"wrongTexels", "wrong texels"},
                     {"greatestError", "greatest error"}};
    for (const BakeMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.builder, std::int64_t{m.size}, 1e3 * m.seconds,
                              m.nanosecondsPerTexel(), m.megatexelsPerSecond(), m.builtTexels,
                              cellOf(m.workingBytes), cellOf(m.nodesPerTexel),
                              cellOf(m.samplesPerTexel), cellOf(m.meanRatio), cellOf(m.wrongTexels),
                              cellOf(m.greatestError)});
    return table;
}

Plot bakePlot(const std::vector<BakeMeasurement>& measurements) {
    std::map<std::string, std::set<int>> sizes;
    for (const BakeMeasurement& m : measurements)
        sizes[m.builder].insert(m.size);
    Plot plot;
    plot.title = "Building maps";
    plot.xLabel = "size in texels";
    plot.yLabel = "ns per texel";
    plot.xLogarithmBase = 2;
    plot.hasLegend = true;
    plot.hasOneRange = true;
    for (const BakeMeasurement& m : measurements)
        if (sizes[m.builder].size() > 1)
            seriesOf(plot, m.builder, m.sample)
                .points.emplace_back(m.size, m.nanosecondsPerTexel());
    return plot;
}

}  // namespace relievo::bench
