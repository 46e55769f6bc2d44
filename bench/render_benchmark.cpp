#include "bench/render_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

#include "bench/stopwatch.h"
#include "bench/technique_maps.h"
#include "commands/progress.h"
#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "surfaces/surface_mesh.h"
#include "textures/sample_reliefs.h"
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
    return view;
}

/// The values of `options.steps` for a technique with a step budget, else nothing, once.
std::vector<std::optional<int>> budgetsOf(const materials::Technique& technique,
                                          const RenderBenchmarkOptions& options) {
    if (materials::budgetParameter(technique) == nullptr)
        return {std::nullopt};
    return {options.steps.begin(), options.steps.end()};
}

std::size_t measurementsPerView(const RenderBenchmarkOptions& options) {
    std::size_t count = 0;
    for (const std::string& technique : options.techniques)
        count += budgetsOf(materials::findTechnique(technique), options).size();
    return count;
}

double frameSeconds(viewer::SceneRenderer& renderer, materials::ReliefMaterial& material,
                    const viewer::View& view, gl::Framebuffer& target, int repeat) {
    // The first frame compiles the program and uploads the maps.
    renderer.draw(material, view, target);
    glFinish();
    return leastSeconds(repeat, [&] {
        renderer.draw(material, view, target);
        glFinish();
    });
}

/// One sample on the GPU, with the maps of some techniques, and what its frames are drawn to.
struct SampleStage {
    viewer::SceneRenderer renderer;
    gl::Framebuffer target;
};

/// A sample with the maps of every technique: those that need the same maps share a stage.
class SampleStages {
  public:
    SampleStages(const std::string& sample, const RenderBenchmarkOptions& options)
        : name_(sample),
          relief_(textures::generateSampleRelief(sample, options.size, options.size)),
          frame_(options.frame) {}

    SampleStage& of(const materials::Technique& technique) {
        const preprocess::ReliefPlan plan = planFor(technique);
        const std::string key = preprocess::optionWords(plan);
        if (const auto found = stages_.find(key); found != stages_.end())
            return found->second;
        SampleStage stage{viewer::SceneRenderer(preprocess::bakeRelief(relief_, plan), name_, {}),
                          gl::Framebuffer(frame_, frame_, std::array<GLenum, 1>{GL_RGBA8})};
        stage.renderer.setSurface(surfaces::makeQuad({1.0f, 1.0f}, 1.0f));
        return stages_.emplace(key, std::move(stage)).first->second;
    }

  private:
    std::string name_;
    textures::DepthMap relief_;
    int frame_;
    std::map<std::string, SampleStage> stages_;
};

RenderMeasurement measureTechnique(SampleStage& stage, const materials::Technique& technique,
                                   std::optional<int> steps, const viewer::View& view,
                                   const viewer::ReferenceFrame& exact,
                                   const RenderBenchmarkOptions& options) {
    materials::ReliefMaterial material = stage.renderer.makeMaterial(technique);
    if (steps)
        material.setParameter(materials::budgetParameter(technique)->name, *steps);
    RenderMeasurement result;
    result.technique = technique.name;
    result.steps = steps;
    result.size = options.size;
    result.seconds = frameSeconds(stage.renderer, material, view, stage.target, options.repeat);
    const viewer::MeasuredFrame frame =
        stage.renderer.measure(material, view, options.frame, options.frame);
    result.work = viewer::countWork(frame);
    result.errors = reference::summarizeErrors(
        viewer::compareFrames(frame, exact, stage.renderer.depthMap(), options.depthScale),
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
        SampleStages stages(sample, options);
        for (const double elevation : options.elevations) {
            const viewer::View view = viewFrom(elevation, options);
            const viewer::ReferenceFrame exact =
                stages.of(materials::findTechnique("normal"))
                    .renderer.trace(view, options.frame, options.frame);
            for (const std::string& name : options.techniques) {
                const materials::Technique& technique = materials::findTechnique(name);
                for (const std::optional<int> steps : budgetsOf(technique, options)) {
                    report.measurements.push_back(measureTechnique(stages.of(technique), technique,
                                                                   steps, view, exact, options));
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
                     {"percentile99NormalDegrees", "p99 normal deg", 3}};
    for (const RenderMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.elevation, m.technique,
                              m.steps ? ReportCell(std::int64_t{*m.steps}) : ReportCell(),
                              1e3 * m.seconds, m.work.meanSteps, m.work.meanFetches,
                              100.0 * m.errors.wrongShare, 100.0 * m.errors.unconvergedShare,
                              100.0 * m.errors.overshotShare, m.size * m.errors.meanDistance,
                              m.size * m.errors.percentile99Distance,
                              m.size * m.errors.maximumDistance, m.errors.meanNormalAngle,
                              m.errors.percentile99NormalAngle});
    return table;
}

Plot renderPlot(const std::vector<RenderMeasurement>& measurements, PlotAgainst against) {
    Plot plot;
    plot.title = "Wrong first hits of search techniques";
    plot.xLabel = against == PlotAgainst::Time ? "ms per frame" : "fetches per pixel";
    plot.yLabel = "wrong first hits in % (none: as half a ray)";
    plot.keyPosition = "top right";
    std::set<double> elevations;
    for (const RenderMeasurement& m : measurements) {
        const double fewest = 0.5 / static_cast<double>(std::max<std::size_t>(m.errors.rays, 1));
        const double x = against == PlotAgainst::Time ? 1e3 * m.seconds : m.work.meanFetches;
        // A technique without lookups has no place on a logarithmic axis.
        if (x > 0.0)
            seriesOf(plot, fmt::format("{}, {}°", m.sample, m.elevation), m.technique)
                .points.emplace_back(x, 100.0 * std::max(m.errors.wrongShare, fewest));
        elevations.insert(m.elevation);
    }
    plot.columns = static_cast<int>(elevations.size());
    return plot;
}

}  // namespace relievo::bench
