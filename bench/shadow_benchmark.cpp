#include "bench/shadow_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "bench/measurement_grid.h"
#include "bench/sample_stages.h"
#include "commands/progress.h"
#include "materials/shadow_registry.h"
#include "viewer/camera.h"
#include "viewer/reference_frame.h"

namespace relievo::bench {
namespace {

// Of the eye and of the light: the relief is neither lit from behind the eye nor against it.
constexpr float kEyeAzimuth = 30.0f;
constexpr float kLightAzimuth = -50.0f;

viewer::View viewUnder(double elevation, double lightSize, const ShadowBenchmarkOptions& options) {
    constexpr float kUnbounded = std::numeric_limits<float>::infinity();
    viewer::View view;
    view.camera =
        viewer::parallelRays(kEyeAzimuth, static_cast<float>(options.viewElevation), 1.0f);
    view.depthScale = static_cast<float>(options.depthScale);
    view.window = {-kUnbounded, -kUnbounded, kUnbounded, kUnbounded};
    view.toLight = viewer::directionTowards(kLightAzimuth, static_cast<float>(elevation));
    view.lightRadius = glm::radians(static_cast<float>(lightSize) / 2.0f);
    view.lightRays = options.lightRays;
    return view;
}

// A method with one of the budgets that it can take; nothing where it has none.
struct BudgetedMethod {
    std::string name;
    const materials::ShadowMethod* method;  // null: no shadows
    std::optional<int> budget;
};

std::vector<BudgetedMethod> budgetedMethods(const ShadowBenchmarkOptions& options) {
    std::vector<BudgetedMethod> result;
    for (const std::string& name : options.methods) {
        const materials::ShadowMethod* const method =
            name == kNoShadow ? nullptr : &materials::findShadowMethod(name);
        const materials::TechniqueParameter* const parameter =
            method ? materials::budgetParameter(*method) : nullptr;
        if (!parameter) {
            result.push_back({name, method, std::nullopt});
            continue;
        }
        for (const int budget : options.budgets)
            if (budget >= parameter->minimum && budget <= parameter->maximum)
                result.push_back({name, method, budget});
    }
    return result;
}

ShadowMeasurement measureMethod(SampleStage& stage, const BudgetedMethod& budgeted,
                                const viewer::View& view, const viewer::ReferenceFrame& exact,
                                const ShadowBenchmarkOptions& options) {
    materials::ReliefMaterial material =
        stage.renderer.makeMaterial(materials::findTechnique(options.technique));
    material.setShadow(budgeted.method);
    if (budgeted.budget)
        material.setParameter(materials::budgetParameter(*budgeted.method)->name, *budgeted.budget);
    ShadowMeasurement result;
    result.method = budgeted.name;
    result.budget = budgeted.budget;
    result.seconds = frameSeconds(stage, material, view, options.repeat);
    result.errors = viewer::summarizeLight(
        stage.renderer.measure(material, view, options.frame, options.frame), exact);
    return result;
}

std::string rowOf(const ShadowMeasurement& m) {
    return m.budget ? fmt::format("{} {}", m.method, *m.budget) : m.method;
}

std::string lightOf(const ShadowMeasurement& m) {
    return m.lightSize > 0.0 ? fmt::format("{}°, {}° across", m.elevation, m.lightSize)
                             : fmt::format("{}°, point", m.elevation);
}

// One number of every measurement: a row a method and budget, a column a light.
template <typename Value, typename Summary>
ReportTable underEveryLight(const std::vector<ShadowMeasurement>& measurements, const Value& value,
                            const Summary& summary) {
    MeasurementGrid grid;
    for (const ShadowMeasurement& m : measurements)
        grid.add(rowOf(m), lightOf(m), value(m));
    return grid.table("method", summary);
}

}  // namespace

ShadowReport measureShadows(const ShadowBenchmarkOptions& options) {
    const auto context = gl::createContext(options.backend);
    const materials::Technique& technique = materials::findTechnique(options.technique);
    const std::vector<BudgetedMethod> methods = budgetedMethods(options);
    ShadowReport report{context->description(), {}};
    commands::Progress progress("frames", options.samples.size() * options.elevations.size() *
                                              options.lightSizes.size() * methods.size());
    for (const std::string& sample : options.samples) {
        SampleStages stages(sample, {options.size, options.frame, options.frame});
        for (const double elevation : options.elevations)
            for (const double lightSize : options.lightSizes) {
                const viewer::View view = viewUnder(elevation, lightSize, options);
                const viewer::ReferenceFrame exact =
                    stages.of(technique).renderer.trace(view, options.frame, options.frame);
                for (const BudgetedMethod& method : methods) {
                    ShadowMeasurement measurement = measureMethod(
                        stages.of(technique, method.method), method, view, exact, options);
                    measurement.sample = sample;
                    measurement.elevation = elevation;
                    measurement.lightSize = lightSize;
                    report.measurements.push_back(std::move(measurement));
                    progress.advance();
                }
            }
    }
    return report;
}

ReportTable shadowTable(const std::vector<ShadowMeasurement>& measurements) {
    ReportTable table;
    table.columns = {
        {"sample", "sample"},         {"elevation", "elevation"}, {"lightSize", "light size"},
        {"method", "method"},         {"budget", "budget"},       {"wrongPercent", "wrong %", 3},
        {"meanPercent", "mean %", 3}, {"meanFetches", "fetches"}, {"milliseconds", "ms"}};
    for (const ShadowMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.elevation, m.lightSize, m.method,
                              m.budget ? ReportCell(std::int64_t{*m.budget}) : ReportCell(),
                              100.0 * m.errors.wrongShare, 100.0 * m.errors.meanError,
                              m.errors.meanFetches, 1e3 * m.seconds});
    return table;
}

std::vector<ReportSection> summariseShadows(const std::vector<ShadowMeasurement>& measurements) {
    const auto wrong = [](const ShadowMeasurement& m) { return 100.0 * m.errors.wrongShare; };
    const auto fetches = [](const ShadowMeasurement& m) { return m.errors.meanFetches; };
    return {
        {"Wrong pixels on the worst relief", "Off by over a tenth of the light; in %.",
         underEveryLight(measurements, wrong, greatestOf)},
        {"Wrong pixels", "In %, mean over the reliefs.",
         underEveryLight(measurements, wrong, meanOf)},
        {"Mean error", "In % of the light, mean over pixels and reliefs.",
         underEveryLight(
             measurements, [](const ShadowMeasurement& m) { return 100.0 * m.errors.meanError; },
             meanOf)},
        {"Texture lookups", "Per pixel, mean over the reliefs.",
         underEveryLight(measurements, fetches, meanOf)},
        {"Texture lookups on each relief", "Per pixel, from the cheapest relief to the dearest.",
         underEveryLight(measurements, fetches, rangeOf)},
        {"Time", "Milliseconds a frame, search and shading included, mean over the reliefs.",
         underEveryLight(
             measurements, [](const ShadowMeasurement& m) { return 1e3 * m.seconds; }, meanOf)},
    };
}

Plot shadowPlot(const std::vector<ShadowMeasurement>& measurements) {
    // Logarithmic axes have no place for 0.
    constexpr double kLeastPercent = 1e-3;
    struct Sums {
        int samples = 0;
        double milliseconds = 0.0;
        double wrongPercent = 0.0;
    };
    Plot plot;
    plot.title = "Self-shadows: wrong pixels, mean over the reliefs";
    plot.xLabel = "ms per frame";
    plot.yLabel = "wrong pixels in %";
    plot.hasLegend = true;
    std::map<std::pair<std::string, std::string>, Sums> sums;
    for (const ShadowMeasurement& m : measurements) {
        Sums& sum = sums[{lightOf(m), rowOf(m)}];
        ++sum.samples;
        sum.milliseconds += 1e3 * m.seconds;
        sum.wrongPercent += 100.0 * m.errors.wrongShare;
    }
    // In the order of the measurements, of which each sample has the same.
    for (const ShadowMeasurement& m : measurements) {
        if (m.sample != measurements.front().sample)
            break;
        const Sums& sum = sums.at({lightOf(m), rowOf(m)});
        seriesOf(plot, "light from " + lightOf(m), m.method)
            .points.emplace_back(sum.milliseconds / sum.samples,
                                 std::max(sum.wrongPercent / sum.samples, kLeastPercent));
    }
    return plot;
}

}  // namespace relievo::bench
