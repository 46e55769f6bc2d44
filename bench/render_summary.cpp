#include "bench/render_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "bench/measurement_grid.h"

namespace relievo::bench {
namespace {

std::string rowOf(const RenderMeasurement& m) {
    return m.steps ? fmt::format("{} {}", m.technique, *m.steps) : m.technique;
}

std::string columnOf(const RenderMeasurement& m) {
    return fmt::format("{}°", m.elevation);
}

// One number of every measurement: a row a technique and budget, a column an elevation.
template <typename Value, typename Summary>
ReportTable atEveryElevation(const std::vector<RenderMeasurement>& measurements, const Value& value,
                             const Summary& summary) {
    MeasurementGrid grid;
    for (const RenderMeasurement& m : measurements)
        grid.add(rowOf(m), columnOf(m), value(m));
    return grid.table("technique", summary);
}

double wrongPercent(const RenderMeasurement& m) {
    return 100.0 * m.errors.wrongShare;
}

double lowestElevation(const std::vector<RenderMeasurement>& measurements) {
    return std::ranges::min(measurements, {}, &RenderMeasurement::elevation).elevation;
}

ReportSection wrongOnEverySample(const std::vector<RenderMeasurement>& measurements) {
    const double elevation = lowestElevation(measurements);
    MeasurementGrid grid;
    for (const RenderMeasurement& m : measurements)
        if (m.elevation == elevation)
            grid.add(rowOf(m), m.sample, wrongPercent(m));
    return {fmt::format("Wrong first hits at {}°", elevation), "In % of the pixels.",
            grid.table("technique", meanOf)};
}

}  // namespace

std::vector<ReportSection> summariseRender(const std::vector<RenderMeasurement>& measurements) {
    if (measurements.empty())
        return {};
    return {
        {"Wrong first hits",
         "Off by over a texel along the ray, or not converged; in % of the pixels, mean over the "
         "reliefs.",
         atEveryElevation(measurements, wrongPercent, meanOf)},
        {"Wrong first hits on the worst relief", "In % of the pixels.",
         atEveryElevation(measurements, wrongPercent, greatestOf)},
        {"Distance from the exact hit", "In texels along the ray, mean over pixels and reliefs.",
         atEveryElevation(
             measurements,
             [](const RenderMeasurement& m) { return m.size * m.errors.meanDistance; }, meanOf)},
        {"Texture lookups", "Per pixel, mean over the reliefs.",
         atEveryElevation(
             measurements, [](const RenderMeasurement& m) { return m.work.meanFetches; }, meanOf)},
        {"Time", "Milliseconds a frame, mean over the reliefs.",
         atEveryElevation(
             measurements, [](const RenderMeasurement& m) { return 1e3 * m.seconds; }, meanOf)},
        wrongOnEverySample(measurements),
    };
}

}  // namespace relievo::bench
