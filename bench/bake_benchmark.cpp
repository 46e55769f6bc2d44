#include "bench/bake_benchmark.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>

#include "bench/bake_builders.h"
#include "bench/stopwatch.h"
#include "commands/program.h"
#include "commands/progress.h"
#include "preprocess/sequential_distances.h"
#include "textures/sample_reliefs.h"

namespace relievo::bench {

namespace {

bool exceeds(const BakeBuilder& builder, int size) {
    return builder.largestSize > 0 && size > builder.largestSize;
}

// Runs `builder` and takes what it says of its work, per texel of the map. Checking distances is
// not part of the time.
BakeMeasurement measure(const BakeBuilder& builder, const BakeInput& input, int repeat) {
    BakeOutput output;
    BakeMeasurement measurement;
    measurement.builder = builder.name;
    measurement.seconds = leastSeconds(repeat, [&] { output = builder.build(input); });
    const auto texels = static_cast<double>(input.map.depth.texels.size());
    if (output.search) {
        measurement.nodesPerTexel = static_cast<double>(output.search->nodes) / texels;
        measurement.samplesPerTexel = static_cast<double>(output.search->samples) / texels;
    }
    if (output.ratios) {
        double sum = 0.0;
        for (const float ratio : output.ratios->texels)
            sum += std::min(ratio, 1.0f);
        measurement.meanRatio = sum / texels;
    }
    if (output.doubtfulDistances) {
        const preprocess::DistanceErrors errors = preprocess::compareDistances(
            *output.doubtfulDistances, preprocess::distancesTo(input.raised, input.map.width(),
                                                               input.map.height(), input.map.wrap));
        measurement.wrongTexels = static_cast<std::int64_t>(errors.tooLarge + errors.tooSmall);
        measurement.greatestError = errors.greatest;
    }
    return measurement;
}

// Whether `builder` can be measured at some size of the options; says what is left out and why.
bool isMeasured(const BakeBuilder& builder, const std::vector<int>& sizes) {
    if (builder.build == nullptr) {
        commands::note(fmt::format(
            "{} is left out: the library was not found when the program was built", builder.name));
        return false;
    }
    for (const int size : sizes)
        if (exceeds(builder, size))
            commands::note(
                fmt::format("{} is left out at {}x{}: at most {}x{} do not take too long",
                            builder.name, size, size, builder.largestSize, builder.largestSize));
    return true;
}

template <typename Value>
ReportCell cellOf(const std::optional<Value>& value) {
    return value ? ReportCell(*value) : ReportCell();
}

}  // namespace

std::vector<BakeMeasurement> measureBake(const BakeBenchmarkOptions& options) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(allowedThreads(options)));
    std::vector<const BakeBuilder*> builders;
    for (const std::string& name : options.builders)
        if (isMeasured(bakeBuilder(name), options.sizes))
            builders.push_back(&bakeBuilder(name));
    commands::Progress progress("maps",
                                options.samples.size() * options.sizes.size() * builders.size());
    std::vector<BakeMeasurement> measurements;
    for (const std::string& sample : options.samples)
        for (const int size : options.sizes) {
            const BakeInput input =
                makeBakeInput(textures::generateSampleRelief(sample, size, size));
            for (const BakeBuilder* builder : builders) {
                if (!exceeds(*builder, size)) {
                    measurements.push_back(measure(*builder, input, options.repeat));
                    measurements.back().sample = sample;
                    measurements.back().size = size;
                }
                progress.advance();
            }
        }
    return measurements;
}

int allowedThreads(const BakeBenchmarkOptions& options) {
    return options.threads > 0 ? options.threads : oneapi::tbb::info::default_concurrency();
}

ReportTable bakeTable(const std::vector<BakeMeasurement>& measurements) {
    ReportTable table;
    table.columns = {{"sample", "sample"},
                     {"builder", "builder"},
                     {"size", "size"},
                     {"milliseconds", "ms"},
                     {"nanosecondsPerTexel", "ns/texel"},
                     {"nodesPerTexel", "nodes/texel"},
                     {"samplesPerTexel", "samples/texel"},
                     {"meanRatio", "mean ratio"},
                     {"wrongTexels", "wrong texels"},
                     {"greatestError", "greatest error"}};
    for (const BakeMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.builder, std::int64_t{m.size}, 1e3 * m.seconds,
                              m.nanosecondsPerTexel(), cellOf(m.nodesPerTexel),
                              cellOf(m.samplesPerTexel), cellOf(m.meanRatio), cellOf(m.wrongTexels),
                              cellOf(m.greatestError)});
    return table;
}

Plot bakePlot(const std::vector<BakeMeasurement>& measurements) {
    Plot plot;
    plot.title = "Building maps";
    plot.xLabel = "size in texels";
    plot.yLabel = "ns per texel";
    plot.xLogarithmBase = 2;
    for (const BakeMeasurement& m : measurements)
        seriesOf(plot, m.builder, m.sample).points.emplace_back(m.size, m.nanosecondsPerTexel());
    return plot;
}

}  // namespace relievo::bench
