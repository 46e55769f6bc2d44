#include "bench/render_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "bench/sample_stages.h"
#include "commands/progress.h"
#include "materials/technique_registry.h"
#include "viewer/camera.h"
#include "viewer/reference_frame.h"
#include "viewer/scene_renderer.h"

namespace relievo::bench {

namespace {

viewer::View viewFrom(double elevation, const RenderBenchmarkOptions& options) {
    constexpr float kUnbounded = std::numeric_limits<float>::infinity();
    viewer::View view;
    view.camera = viewer::parallelRays(static_cast<float>(options.azimuth),
                                       static_cast<float>(elevation), 1.0f);
    view.depthScale = static_cast<float>(options.depthScale);
    view.window = {-kUnbounded, -kUnbounded, kUnbounded, kUnbounded};
    view.slopes = options.normals;
    return view;
}

/// The values of `options.steps` that the step budget of a technique can take; nothing, once, for a
/// technique without one.
std::vector<std::optional<int>> budgetsOf(const materials::Technique& technique,
                                          const RenderBenchmarkOptions& options) {
    const materials::TechniqueParameter* const budget = materials::budgetParameter(technique);
    if (budget == nullptr)
        return {std::nullopt};
    std::vector<std::optional<int>> budgets;
    for (const int steps : options.steps)
        if (steps >= budget->minimum && steps <= budget->maximum)
            budgets.emplace_back(steps);
    return budgets;
}

std::size_t measurementsPerView(const RenderBenchmarkOptions& options) {
    std::size_t count = 0;
    for (const std::string& technique : options.techniques)
        count += budgetsOf(materials::findTechnique(technique), options).size();
    return count;
}

double meanDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
        sum += k % 4 == 3 ? 0.0 : std::abs(static_cast<double>(a[k]) - static_cast<double>(b[k]));
    return sum / static_cast<double>(a.size() / 4 * 3);
}

/// What is true of one sample from one elevation.
struct ExactView {
    viewer::View view;
    viewer::ReferenceFrame hits;
    std::vector<float> picture;
};

ExactView traceExactly(SampleStage& stage, double elevation,
                       const RenderBenchmarkOptions& options) {
    ExactView exact{viewFrom(elevation, options), {}, {}};
    exact.hits = stage.renderer.trace(exact.view, options.frame, options.frame);
    stage.renderer.drawReference(exact.hits, exact.view, stage.target);
    exact.picture = stage.target.read(0);
    return exact;
}

RenderMeasurement measureTechnique(SampleStage& stage, const materials::Technique& technique,
                                   std::optional<int> steps, const ExactView& exact,
                                   const RenderBenchmarkOptions& options) {
    materials::ReliefMaterial material = stage.renderer.makeMaterial(technique);
    material.pixelRays = 1;  // as errors and lookups are counted
    if (steps)
        material.setParameter(materials::budgetParameter(technique)->name, *steps);
    RenderMeasurement result;
    result.technique = technique.name;
    result.steps = steps;
    result.size = options.size;
    result.seconds = frameSeconds(stage, material, exact.view, options.repeat);
    result.pictureDifference = meanDifference(stage.target.read(0), exact.picture);
    const viewer::MeasuredFrame frame =
        stage.renderer.measure(material, exact.view, options.frame, options.frame);
    result.work = viewer::countWork(frame);
    result.errors = reference::summarizeErrors(
        viewer::compareFrames(frame, exact.hits, stage.renderer.depthMap(), options.depthScale),
        1.0 / options.size);
    return result;
}

}  // namespace

RenderReport measureRender(const RenderBenchmarkOptions& options) {
    const auto context = gl::createContext(options.backend);
    RenderReport report{context->description(), {}};
    commands::Progress progress("frames", options.samples.size() * options.elevations.size() *
                                              measurementsPerView(options));
    for (const std::string& sample : options.samples) {
        SampleStages stages(sample, {.size = options.size,
                                     .width = options.frame,
                                     .height = options.frame,
                                     .slopes = options.normals});
        for (const double elevation : options.elevations) {
            const ExactView exact =
                traceExactly(stages.of(materials::findTechnique("normal")), elevation, options);
            for (const std::string& name : options.techniques) {
                const materials::Technique& technique = materials::findTechnique(name);
                for (const std::optional<int> steps : budgetsOf(technique, options)) {
                    report.measurements.push_back(
                        measureTechnique(stages.of(technique), technique, steps, exact, options));
                    report.measurements.back().sample = sample;
                    report.measurements.back().elevation = elevation;
                    progress.advance();
                }
            }
        }
    }
    return report;
}

ReportTable renderTable(const std::vector<RenderMeasurement>& measurements) {
    ReportTable table;
    table.columns = {{"sample", "sample"},
                     {"elevation", "elevation"},
                     {"technique", "technique"},
                     {"stepBudget", "budget"},
                     {"milliseconds", "ms"},
                     {"meanSteps", "steps"},
                     {"meanFetches", "fetches"},
                     {"wrongPercent", "wrong %", 3},
                     {"unconvergedPercent", "unconverged %", 3},
                     {"overshotPercent", "overshot %", 3},
                     {"meanDistanceTexels", "mean texels", 3},
                     {"percentile99DistanceTexels", "p99 texels", 3},
                     {"maximumDistanceTexels", "max texels", 3},
                     {"meanNormalDegrees", "normal deg", 3},
                     {"percentile99NormalDegrees", "p99 normal deg", 3},
                     {"picturePercent", "picture %", 3}};
    for (const RenderMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.elevation, m.technique,
                              m.steps ? ReportCell(std::int64_t{*m.steps}) : ReportCell(),
                              1e3 * m.seconds, m.work.meanSteps, m.work.meanFetches,
                              100.0 * m.errors.wrongShare, 100.0 * m.errors.unconvergedShare,
                              100.0 * m.errors.overshotShare, m.size * m.errors.meanDistance,
                              m.size * m.errors.percentile99Distance,
                              m.size * m.errors.maximumDistance, m.errors.meanNormalAngle,
                              m.errors.percentile99NormalAngle, 100.0 * m.pictureDifference});
    return table;
}

namespace {

/// The means over the samples of one technique and budget from one elevation.
struct MeanErrors {
    int samples = 0;
    double cost = 0.0;
    double wrongPercent = 0.0;
    double texels = 0.0;
};

using MeanKey = std::tuple<double, std::string, std::optional<int>>;

std::map<MeanKey, MeanErrors> meansOverSamples(const std::vector<RenderMeasurement>& measurements,
                                               PlotAgainst against) {
    std::map<MeanKey, MeanErrors> sums;
    for (const RenderMeasurement& m : measurements) {
        MeanErrors& sum = sums[{-m.elevation, m.technique, m.steps}];
        ++sum.samples;
        sum.cost += against == PlotAgainst::Time ? 1e3 * m.seconds : m.work.meanFetches;
        // Logarithmic axes have no place for 0: no wrong hit is shown as half of one.
        const double fewest = 0.5 / static_cast<double>(std::max<std::size_t>(m.errors.rays, 1));
        sum.wrongPercent += 100.0 * std::max(m.errors.wrongShare, fewest);
        sum.texels += m.size * m.errors.meanDistance;
    }
    return sums;
}

}  // namespace

Plot renderPlot(const std::vector<RenderMeasurement>& measurements, PlotAgainst against) {
    constexpr double kLeastTexels = 1e-6;
    Plot plot;
    plot.title = "Errors of search techniques, mean over the reliefs";
    plot.xLabel = against == PlotAgainst::Time ? "ms per frame" : "fetches per pixel";
    plot.yLabel = "error";
    plot.hasLegend = true;
    const auto means = meansOverSamples(measurements, against);
    std::set<double> elevations;
    const auto addRow = [&](const char* title, const auto& error) {
        for (const auto& [key, sum] : means) {
            const auto& [elevation, technique, steps] = key;
            // A technique without lookups has no place on a logarithmic axis.
            if (sum.cost > 0.0)
                seriesOf(plot, fmt::format("{}, {}°", title, -elevation), technique)
                    .points.emplace_back(sum.cost / sum.samples, error(sum) / sum.samples);
            elevations.insert(elevation);
        }
    };
    addRow("wrong first hits in % (none: as half a ray)",
           [](const MeanErrors& sum) { return sum.wrongPercent; });
    addRow("distance where both hit, in texels",
           [](const MeanErrors& sum) { return std::max(sum.texels, kLeastTexels * sum.samples); });
    plot.columns = static_cast<int>(elevations.size());
    return plot;
}

}  // namespace relievo::bench
