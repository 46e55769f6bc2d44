#include "bench/bake_benchmark.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "bench/stopwatch.h"
#include "commands/progress.h"
#include "preprocess/cones_by_levels.h"
#include "preprocess/conservative_cones.h"
#include "preprocess/derivatives.h"
#include "preprocess/normals.h"
#include "textures/sample_reliefs.h"

namespace relievo::bench {

namespace {

/// What builders start from.
struct BakeInput {
    textures::DepthMap map;
    preprocess::Derivatives derivatives;
};

/// Counts of work that a run may report.
struct BakeWork {
    std::optional<double> nodesPerTexel;
};

struct BuilderEntry {
    BakeBuilder builder;
    void (*build)(const BakeInput& input, BakeWork& work);
};

template <preprocess::ConeGuarantee kGuarantee>
void buildExactCones(const BakeInput& input, BakeWork& work) {
    preprocess::SlopeSearchStatistics statistics;
    preprocess::buildConservativeCones(input.map, kGuarantee, {}, &statistics);
    work.nodesPerTexel =
        static_cast<double>(statistics.nodes) / static_cast<double>(input.map.depth.texels.size());
}

constexpr std::array kEntries{
    BuilderEntry{
        {"derivatives", "derivative map from the depth map"},
        [](const BakeInput& input, BakeWork&) { preprocess::buildDerivatives(input.map); }},
    BuilderEntry{{"normals", "normal map from the derivative map"},
                 [](const BakeInput& input, BakeWork&) {
                     preprocess::buildNormals(input.derivatives, 0.1);
                 }},
    BuilderEntry{{"cones-bilinear", "conservative cones, safe on the bilinear surface"},
                 buildExactCones<preprocess::ConeGuarantee::Bilinear>},
    BuilderEntry{{"cones-texel", "conservative cones between texel centres"},
                 buildExactCones<preprocess::ConeGuarantee::Texel>},
    BuilderEntry{
        {"cones-levels", "conservative cones by 256 depth levels"},
        [](const BakeInput& input, BakeWork&) { preprocess::buildConesByLevels(input.map); }},
};

constexpr auto kBuilders = [] {
    std::array<BakeBuilder, kEntries.size()> builders;
    std::transform(kEntries.begin(), kEntries.end(), builders.begin(),
                   [](const BuilderEntry& entry) { return entry.builder; });
    return builders;
}();

const BuilderEntry& entryOf(const std::string& name) {
    const auto found =
        std::find_if(kEntries.begin(), kEntries.end(),
                     [&](const BuilderEntry& entry) { return entry.builder.name == name; });
    if (found == kEntries.end())
        throw std::invalid_argument("no map builder is called " + name);
    return *found;
}

}  // namespace

std::span<const BakeBuilder> bakeBuilders() {
    return kBuilders;
}

std::vector<BakeMeasurement> measureBake(const BakeBenchmarkOptions& options) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(allowedThreads(options)));
    commands::Progress progress(
        "maps", options.samples.size() * options.sizes.size() * options.builders.size());
    std::vector<BakeMeasurement> measurements;
    for (const std::string& sample : options.samples)
        for (const int size : options.sizes) {
            BakeInput input{textures::generateSampleRelief(sample, size, size), {}};
            input.derivatives = preprocess::buildDerivatives(input.map);
            for (const std::string& builder : options.builders) {
                const BuilderEntry& entry = entryOf(builder);
                BakeWork work;
                const double seconds =
                    leastSeconds(options.repeat, [&] { entry.build(input, work); });
                measurements.push_back({sample, builder, size, seconds, work.nodesPerTexel});
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
                     {"nodesPerTexel", "nodes/texel"}};
    for (const BakeMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.builder, std::int64_t{m.size}, 1e3 * m.seconds,
                              m.nanosecondsPerTexel(),
                              m.nodesPerTexel ? ReportCell(*m.nodesPerTexel) : ReportCell()});
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
