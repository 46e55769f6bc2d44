#include "bench/render_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "bench/measurement_grid.h"

namespace relievo::bench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

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

// What a user pays for a picture that is right: of every technique with a budget the least one that
// is wrong on at most 0.1 % of the pixels, relief by relief; nothing where on some relief none is
// enough.
template <typename Cost>
ReportTable costOfBeingRight(const std::vector<RenderMeasurement>& measurements, const Cost& cost) {
    constexpr double kMostPercent = 0.1;
    std::map<std::tuple<std::string, double, std::string>, double> least;
    for (const RenderMeasurement& m : measurements) {
        double& known =
            least.try_emplace({m.technique, m.elevation, m.sample}, kNever).first->second;
        if (wrongPercent(m) <= kMostPercent)
            known = std::min(known, cost(m));
    }
    MeasurementGrid grid;
    for (const RenderMeasurement& m : measurements)
        grid.add(m.technique, columnOf(m), least.at({m.technique, m.elevation, m.sample}));
    return grid.table("technique", [](const std::vector<double>& values) {
        return greatestOf(values) == ReportCell(kNever) ? ReportCell() : meanOf(values);
    });
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
        {"Difference of the picture",
         "From the picture of the exact hits, in % of white, mean over pixels and reliefs.",
         atEveryElevation(
             measurements, [](const RenderMeasurement& m) { return 100.0 * m.pictureDifference; },
             meanOf)},
        {"Lookups for a right picture",
         "Per pixel, with the least budget that is wrong on at most 0.1 % of the pixels of a "
         "relief, "
         "mean over the reliefs; – where on some relief no budget was enough.",
         costOfBeingRight(measurements,
                          [](const RenderMeasurement& m) { return m.work.meanFetches; })},
        {"Time for a right picture", "Milliseconds a frame, likewise.",
         costOfBeingRight(measurements,
                          [](const RenderMeasurement& m) { return 1e3 * m.seconds; })},
        wrongOnEverySample(measurements),
    };
}

}  // namespace relievo::bench
