#include "bench/sparkle_benchmark.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "bench/stopwatch.h"
#include "bench/technique_maps.h"
#include "commands/progress.h"
#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "surfaces/surface_mesh.h"
#include "textures/sample_reliefs.h"
#include "viewer/camera.h"
#include "viewer/scene_renderer.h"

namespace relievo::bench {
namespace {

// The plane is 1 wide. From this height the frame reaches from the near border of the plane to far
// before the other one.
constexpr float kEyeHeight = 0.015f;
constexpr float kFieldOfView = 20.0f;
// Parts of a pixel by which the picture moves in a frame: no simple fractions, so that pixels fall
// on all places of the relief.
constexpr float kPixelsAcross = 0.31f;
constexpr float kPixelsDown = 0.13f;

viewer::View viewOf(int number, const SparkleBenchmarkOptions& options) {
    constexpr float kUnbounded = std::numeric_limits<float>::infinity();
    const float pixel = kFieldOfView / static_cast<float>(options.frame);
    const auto step = static_cast<float>(number);
    viewer::OrbitCamera orbit;
    orbit.fieldOfView = kFieldOfView;
    orbit.azimuth = 25.0f + step * kPixelsAcross * pixel;
    orbit.elevation = static_cast<float>(options.elevation) + step * kPixelsDown * pixel;
    // The eye stays where it is, and turns.
    const glm::vec3 eye(-0.3f, -0.35f, kEyeHeight);
    orbit.distance = 0.1f;
    orbit.target = eye - orbit.distance * viewer::directionTowards(orbit.azimuth, orbit.elevation);
    viewer::View view;
    view.camera = viewer::perspectiveCamera(orbit, 1.0f);
    view.toLight = viewer::directionTowards(-50.0f, 40.0f);
    view.depthScale = static_cast<float>(options.depthScale);
    view.window = {-kUnbounded, -kUnbounded, kUnbounded, kUnbounded};
    return view;
}

gl::Framebuffer makeTarget(int size) {
    return gl::Framebuffer(size, size, std::array<GLenum, 1>{GL_RGBA32F});
}

viewer::Picture draw(viewer::SceneRenderer& renderer, materials::ReliefMaterial& material,
                     const viewer::View& view, gl::Framebuffer& target) {
    renderer.draw(material, view, target);
    viewer::Picture picture(target.width(), target.height());
    picture.rgba = target.read(0);
    return picture;
}

viewer::SceneRenderer makeStage(std::vector<textures::MapSet> levels, const std::string& name,
                                const SparkleBenchmarkOptions& options) {
    viewer::SceneRenderer stage(std::move(levels), name, {});
    const auto tiles = static_cast<float>(options.tiles);
    stage.setSurface(surfaces::makeQuad({tiles, tiles}, 1.0f));
    return stage;
}

preprocess::ReliefPlan planWithLevels(std::string_view technique) {
    preprocess::ReliefPlan plan = planFor(materials::findTechnique(technique));
    plan.mips = true;
    return plan;
}

std::vector<viewer::Picture> trueFrames(const textures::DepthMap& relief, const std::string& name,
                                        const SparkleBenchmarkOptions& options,
                                        const std::function<void()>& advance) {
    const materials::Technique& technique = materials::findTechnique("exact");
    viewer::SceneRenderer stage =
        makeStage({preprocess::bakeRelief(relief, planFor(technique))}, name, options);
    materials::ReliefMaterial material = stage.makeMaterial(technique);
    gl::Framebuffer target = makeTarget(options.frame * options.supersampling);
    std::vector<viewer::Picture> frames;
    for (int number = 0; number < options.frames; ++number) {
        frames.push_back(viewer::averaged(draw(stage, material, viewOf(number, options), target),
                                          options.supersampling));
        advance();
    }
    return frames;
}

SparkleMeasurement measureStage(viewer::SceneRenderer& stage, const std::string& technique,
                                int rays, std::span<const viewer::Picture> truth,
                                const SparkleBenchmarkOptions& options) {
    SparkleMeasurement result;
    result.technique = technique;
    result.rays = rays;
    materials::ReliefMaterial material = stage.makeMaterial(materials::findTechnique(technique));
    material.pixelRays = rays;
    gl::Framebuffer target = makeTarget(options.frame);
    viewer::TemporalError errors;
    for (int number = 0; number < options.frames; ++number) {
        viewer::Picture frame = draw(stage, material, viewOf(number, options), target);
        errors.add(frame, truth[static_cast<std::size_t>(number)]);
        if (number == 0)
            result.picture = std::move(frame);
    }
    result.errors = errors.statistics();
    const viewer::View first = viewOf(0, options);
    result.work = viewer::countWork(stage.measure(material, first, options.frame, options.frame));
    result.seconds = leastSeconds(options.repeat, [&] {
        stage.draw(material, first, target);
        glFinish();
    });
    return result;
}

}  // namespace

SparkleReport measureSparkle(const SparkleBenchmarkOptions& options) {
    const auto context = gl::createContext(options.backend);
    SparkleReport report{context->description(), {}, {}};
    commands::Progress progress(
        "frames", options.samples.size() *
                      (static_cast<std::size_t>(options.frames) + 4 * options.techniques.size()));
    for (const std::string& sample : options.samples) {
        const textures::DepthMap relief =
            textures::generateSampleRelief(sample, options.size, options.size);
        const std::vector<viewer::Picture> truth =
            trueFrames(relief, sample, options, [&] { progress.advance(); });
        report.truths.push_back(truth.front());
        for (const std::string& technique : options.techniques) {
            std::vector<textures::MapSet> levels =
                preprocess::bakeLevels(relief, planWithLevels(technique));
            viewer::SceneRenderer plain = makeStage({levels.front()}, sample, options);
            viewer::SceneRenderer filtered = makeStage(std::move(levels), sample, options);
            for (const int rays : {1, options.rays})
                for (const bool hasLevels : {false, true}) {
                    SparkleMeasurement measurement =
                        measureStage(hasLevels ? filtered : plain, technique, rays, truth, options);
                    measurement.sample = sample;
                    measurement.hasLevels = hasLevels;
                    report.measurements.push_back(std::move(measurement));
                    progress.advance();
                }
        }
    }
    return report;
}

ReportTable sparkleTable(const std::vector<SparkleMeasurement>& measurements) {
    ReportTable table;
    table.columns = {{"sample", "sample"},
                     {"technique", "technique"},
                     {"levels", "levels"},
                     {"rays", "rays"},
                     {"sparklePercent", "sparkle %", 3},
                     {"lastingPercent", "lasting %", 3},
                     {"biasPercent", "bias %", 3},
                     {"meanFetches", "fetches a ray"},
                     {"milliseconds", "ms"}};
    for (const SparkleMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.technique, std::string(m.hasLevels ? "yes" : "no"),
                              std::int64_t{m.rays}, 100.0 * m.errors.sparkle,
                              100.0 * m.errors.lasting, 100.0 * m.errors.bias, m.work.meanFetches,
                              1e3 * m.seconds});
    return table;
}

ReportTable meanSparkleTable(const std::vector<SparkleMeasurement>& measurements) {
    // The measurements of every sample come in the same order.
    const auto isFirst = [&](const SparkleMeasurement& m) {
        return m.sample == measurements.front().sample;
    };
    const auto kinds = static_cast<std::size_t>(std::ranges::count_if(measurements, isFirst));
    const double share = static_cast<double>(kinds) / static_cast<double>(measurements.size());
    std::vector<SparkleMeasurement> means(kinds);
    for (std::size_t k = 0; k < measurements.size(); ++k) {
        const SparkleMeasurement& m = measurements[k];
        SparkleMeasurement& mean = means[k % kinds];
        mean.technique = m.technique;
        mean.hasLevels = m.hasLevels;
        mean.rays = m.rays;
        mean.errors.sparkle += share * m.errors.sparkle;
        mean.errors.lasting += share * m.errors.lasting;
        mean.errors.bias += share * m.errors.bias;
        mean.work.meanFetches += share * m.work.meanFetches;
        mean.seconds += share * m.seconds;
    }
    ReportTable table = sparkleTable(means);
    table.columns.erase(table.columns.begin());
    for (auto& row : table.rows)
        row.erase(row.begin());
    return table;
}

Plot sparklePlot(const std::vector<SparkleMeasurement>& measurements) {
    Plot plot;
    plot.title = "Sparkle on a receding plane";
    plot.xLabel = "ms per frame";
    plot.yLabel = "sparkle in % of white";
    for (const SparkleMeasurement& m : measurements)
        seriesOf(plot, m.sample, m.technique + (m.hasLevels ? " with levels" : ""))
            .points.emplace_back(1e3 * m.seconds, std::max(100.0 * m.errors.sparkle, 1e-3));
    return plot;
}

}  // namespace relievo::bench
