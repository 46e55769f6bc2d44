#include "bench/bake_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "bench/bake_builders.h"
#include "bench/measurement_grid.h"

namespace relievo::bench {

namespace {

using Measurements = std::vector<BakeMeasurement>;

constexpr int kComparedSize = 1024;
constexpr int kGrowthFrom = 512;

std::string squareOf(int size) {
    return fmt::format("{}²", size);
}

std::vector<int> sizesOf(const Measurements& measurements) {
    std::vector<int> sizes;
    for (const BakeMeasurement& m : measurements)
        sizes.push_back(m.size);
    return sizes;
}

void addSection(std::vector<ReportSection>& sections, ReportSection section) {
    if (!section.table.rows.empty())
        sections.push_back(std::move(section));
}

ReportSection speedAtEverySize(const Measurements& measurements) {
    MeasurementGrid grid;
    for (const BakeMeasurement& m : measurements)
        grid.add(m.builder, squareOf(m.size), m.megatexelsPerSecond());
    return {"Speed", "Mtexel/s, from the slowest sample to the fastest.",
            grid.table("builder", rangeOf)};
}

// One number of each measurement at one size, if it has it: a row a builder, a column a sample.
template <typename Value>
ReportTable onEverySample(const Measurements& measurements, int size, const Value& valueOf) {
    MeasurementGrid grid;
    for (const BakeMeasurement& m : measurements)
        if (const std::optional<double> value = valueOf(m); value && m.size == size)
            grid.add(m.builder, m.sample, *value);
    return grid.table("builder", meanOf);
}

/// Time per texel of each builder, sample and size.
using Times = std::map<std::tuple<std::string, std::string, int>, double>;

Times timesOf(const Measurements& measurements) {
    Times times;
    for (const BakeMeasurement& m : measurements)
        times[{m.builder, m.sample, m.size}] = m.nanosecondsPerTexel();
    return times;
}

std::map<std::string, int> largestSizes(const Measurements& measurements) {
    std::map<std::string, int> largest;
    for (const BakeMeasurement& m : measurements)
        largest[m.builder] = std::max(largest[m.builder], m.size);
    return largest;
}

std::string builderAt(const BakeMeasurement& measurement) {
    return fmt::format("{} at {}", measurement.builder, squareOf(measurement.size));
}

// Time per texel at the largest size of each builder over that at 512², or at the least size.
ReportSection growth(const Measurements& measurements) {
    const std::vector<int> sizes = sizesOf(measurements);
    const int from = std::find(sizes.begin(), sizes.end(), kGrowthFrom) != sizes.end()
                         ? kGrowthFrom
                         : *std::min_element(sizes.begin(), sizes.end());
    const std::map<std::string, int> largest = largestSizes(measurements);
    const Times times = timesOf(measurements);
    MeasurementGrid grid;
    for (const BakeMeasurement& m : measurements)
        if (m.size > from && m.size == largest.at(m.builder))
            if (const auto first = times.find({m.builder, m.sample, from}); first != times.end())
                grid.add(builderAt(m), m.sample, m.nanosecondsPerTexel() / first->second);
    return {"Growth", fmt::format("Time per texel over that at {}.", squareOf(from)),
            grid.table("builder", meanOf)};
}

// The largest size at which both were measured; 0 without one.
int largestCommonSize(const Measurements& measurements, const std::string& one,
                      const std::string& other) {
    int largest = 0;
    for (const BakeMeasurement& a : measurements)
        for (const BakeMeasurement& b : measurements)
            if (a.builder == one && b.builder == other && a.size == b.size)
                largest = std::max(largest, a.size);
    return largest;
}

ReportSection againstBaselines(const Measurements& measurements) {
    const Times times = timesOf(measurements);
    MeasurementGrid grid;
    for (const BakeBuilder& builder : bakeBuilders())
        for (const BakeBuilder& baseline : bakeBuilders()) {
            if (builder.product.empty() || builder.product != baseline.product ||
                builder.isBaseline || !baseline.isBaseline)
                continue;
            const int size = largestCommonSize(measurements, builder.name, baseline.name);
            for (const BakeMeasurement& m : measurements)
                if (const auto other = times.find({baseline.name, m.sample, size});
                    m.builder == builder.name && m.size == size && other != times.end())
                    grid.add(
                        fmt::format("{} : {}, {}", builder.name, baseline.name, squareOf(size)),
                        m.sample, other->second / m.nanosecondsPerTexel());
        }
    return {"Against baselines", "How many times faster the first is than the second.",
            grid.table("builders", meanOf)};
}

// At the largest size of each builder, where tables of a fixed size hardly count.
ReportSection memory(const Measurements& measurements) {
    const std::map<std::string, int> largest = largestSizes(measurements);
    MeasurementGrid grid;
    for (const BakeMeasurement& m : measurements)
        if (m.workingBytes && m.size == largest.at(m.builder)) {
            grid.add(builderAt(m), "measured", *m.workingBytes);
            if (const auto stated = bakeBuilder(m.builder).statedBytes)
                grid.add(builderAt(m), "counted on by relievo-bake", *stated);
        }
    return {"Memory", "Bytes a texel beyond map and result: the most on any sample.",
            grid.table("builder", greatestOf)};
}

}  // namespace

int sizeForComparison(const std::vector<int>& sizes) {
    const bool has = std::find(sizes.begin(), sizes.end(), kComparedSize) != sizes.end();
    return has ? kComparedSize : *std::max_element(sizes.begin(), sizes.end());
}

std::vector<ReportSection> summariseBake(const Measurements& measurements) {
    std::vector<ReportSection> sections;
    if (measurements.empty())
        return sections;
    const int size = sizeForComparison(sizesOf(measurements));
    addSection(sections, speedAtEverySize(measurements));
    addSection(sections, {"Speed on every sample", fmt::format("Mtexel/s at {}.", squareOf(size)),
                          onEverySample(measurements, size, [](const BakeMeasurement& m) {
                              return std::optional(m.megatexelsPerSecond());
                          })});
    addSection(sections, growth(measurements));
    addSection(sections, againstBaselines(measurements));
    addSection(
        sections,
        {"Mean ratios", fmt::format("At {}; ratios above 1 count as 1.", squareOf(size)),
         onEverySample(measurements, size, [](const BakeMeasurement& m) { return m.meanRatio; })});
    addSection(sections, memory(measurements));
    return sections;
}

std::vector<ReportSection> summariseEdits(const std::vector<EditMeasurement>& measurements) {
    MeasurementGrid means;
    MeasurementGrid worst;
    const auto add = [&](const EditMeasurement& m, const std::string& column) {
        means.add(m.sample, column, m.meanSeconds / m.buildSeconds);
        worst.add(m.sample, column, m.worstSeconds / m.buildSeconds);
    };
    for (const EditMeasurement& m : measurements)
        add(m, m.brush);
    for (const EditMeasurement& m : measurements)
        add(m, "all");
    std::vector<ReportSection> sections;
    addSection(sections,
               {"Strokes of a brush, mean time", "Over the time that all cones-bilinear take anew.",
                means.table("sample", meanOf)});
    addSection(sections, {"Strokes of a brush, worst time",
                          "Over the time that all cones-bilinear take anew.",
                          worst.table("sample", greatestOf)});
    return sections;
}

std::vector<ReportSection> summariseSearches(const std::vector<SearchMeasurement>& measurements) {
    MeasurementGrid grid;
    for (const SearchMeasurement& m : measurements)
        grid.add(m.search, fmt::format("lookups at {}°", m.elevation), m.meanLookups);
    for (const SearchMeasurement& m : measurements)
        grid.add(m.search, fmt::format("wrong % at {}°", m.elevation), 100.0 * m.wrongShare);
    for (const SearchMeasurement& m : measurements)
        if (m.meanRatio)
            grid.add(m.search, "mean ratio", *m.meanRatio);
    std::vector<ReportSection> sections;
    addSection(sections, {"Lookups to the hit",
                          "Means over all samples. A hit is wrong when it is off by over a texel "
                          "along the ray, or not found.",
                          grid.table("search", meanOf)});
    return sections;
}

}  // namespace relievo::bench
