#include "bench/scene_benchmark.h"

#include <algorithm>
#include <array>
#include <utility>

#include "bench/scenes.h"
#include "viewer/picture.h"

namespace relievo::bench {
namespace {

constexpr int kFewestSteps = 16;
constexpr int kMostSteps = 4096;
constexpr int kShadowTexels = 2048;

/// A model as one technique shows it.
class SceneFrames {
  public:
    SceneFrames(const SceneModel& model, const std::string& technique,
                const SceneBenchmarkOptions& options)
        : technique_(technique),
          scene_(model, materials::findTechnique(technique), options.size),
          width_(options.frame * 4 / 3),
          height_(options.frame) {
        view_.camera = viewer::perspectiveCamera(
            model.eye, static_cast<float>(width_) / static_cast<float>(height_));
        view_.toLight = viewer::directionTowards(model.light.azimuth, model.light.elevation);
    }

    void setParameter(std::string_view name, double value) { scene_.setParameter(name, value); }

    SceneMeasurement measure(bool skipsHidden) {
        if (exact_.empty())
            exact_ = traceScene(scene_.exactObjects(), view_.camera, width_, height_);
        view_.skipHidden = skipsHidden;
        const viewer::VisibleFrame frame = frames_.show(scene_.objects(), view_, width_, height_);
        return {technique_,
                std::nullopt,
                std::nullopt,
                skipsHidden,
                frame.fetches,
                static_cast<double>(frame.fetches) / static_cast<double>(frame.pixels.size()),
                compareScene(frame, exact_, view_.camera)};
    }

    viewer::Picture draw(const viewer::OrbitCamera& light) {
        const viewer::ShadowMap shadows = frames_.castShadows(
            scene_.objects(), viewer::orthographicCamera(light, 1.0f), kShadowTexels);
        view_.shadowMap = &shadows;
        gl::Framebuffer target(width_, height_, std::array<GLenum, 1>{GL_RGBA8});
        frames_.draw(scene_.objects(), view_, target);
        view_.shadowMap = nullptr;
        viewer::Picture picture(width_, height_);
        picture.rgba = target.read(0);
        return picture;
    }

  private:
    std::string technique_;
    StagedScene scene_;
    int width_;
    int height_;
    viewer::FrameRenderer frames_;
    viewer::FrameView view_;
    std::vector<std::optional<viewer::ExactHit>> exact_;
};

constexpr std::string_view kPixelError = "pixel-error";

bool takesPixelError(const materials::Technique& technique) {
    return std::ranges::find(technique.parameters, kPixelError,
                             &materials::TechniqueParameter::name) != technique.parameters.end();
}

// A technique with each target, if it takes one, with hidden objects skipped and searched.
void measureTechnique(const SceneModel& model, const std::string& technique,
                      const SceneBenchmarkOptions& options,
                      std::vector<SceneMeasurement>& measurements) {
    SceneFrames frames(model, technique, options);
    std::vector<std::optional<double>> targets{std::nullopt};
    if (takesPixelError(materials::findTechnique(technique)))
        targets.assign(options.pixelErrors.begin(), options.pixelErrors.end());
    for (const std::optional<double>& target : targets) {
        if (target)
            frames.setParameter(kPixelError, *target);
        for (const bool skipsHidden : {true, false})
            measurements.emplace_back(frames.measure(skipsHidden)).pixelError = target;
    }
}

// Relief mapping with more and more steps, powers of two, until it is no more wrong than `goal` by
// any measure, or has the most steps.
void measureReliefMapping(const SceneModel& model, const viewer::SceneErrors& goal,
                          const SceneBenchmarkOptions& options,
                          std::vector<SceneMeasurement>& measurements) {
    SceneFrames relief(model, "relief", options);
    for (int steps = kFewestSteps; steps <= kMostSteps; steps *= 2) {
        relief.setParameter("linear-steps", steps);
        SceneMeasurement& result = measurements.emplace_back(relief.measure(false));
        result.steps = steps;
        if (result.errors.wrongObjectShare <= goal.wrongObjectShare &&
            result.errors.wrongShare <= goal.wrongShare &&
            result.errors.meanShift <= goal.meanShift)
            return;
    }
}

}  // namespace

std::vector<SceneMeasurement> measureScene(const SceneBenchmarkOptions& options) {
    const SceneModel model = sceneModel(options.scene);
    std::vector<SceneMeasurement> measurements;
    viewer::SceneErrors goal;
    for (const std::string& technique : options.techniques) {
        measureTechnique(model, technique, options, measurements);
        if (technique == options.techniques.front())
            goal = measurements.back().errors;
    }
    measureReliefMapping(model, goal, options, measurements);
    return measurements;
}

ReportTable sceneTable(const std::vector<SceneMeasurement>& measurements) {
    ReportTable table;
    table.columns = {{"technique", "technique"},
                     {"pixelError", "target"},
                     {"stepBudget", "budget"},
                     {"hiddenObjects", "hidden objects"},
                     {"fetches", "lookups", 9},
                     {"fetchesPerPixel", "per pixel"},
                     {"wrongObjectPercent", "wrong object %", 3},
                     {"wrongPercent", "wrong %", 3},
                     {"meanShiftPixels", "mean shift", 3}};
    for (const SceneMeasurement& m : measurements)
        table.rows.push_back({m.technique, m.pixelError ? ReportCell(*m.pixelError) : ReportCell(),
                              m.steps ? ReportCell(std::int64_t{*m.steps}) : ReportCell(),
                              std::string(m.skipsHidden ? "skipped" : "searched"),
                              static_cast<std::int64_t>(m.fetches), m.fetchesPerPixel,
                              100.0 * m.errors.wrongObjectShare, 100.0 * m.errors.wrongShare,
                              m.errors.meanShift});
    return table;
}

Plot scenePlot(const std::vector<SceneMeasurement>& measurements) {
    Plot plot;
    plot.title = "A frame of several objects";
    plot.xLabel = "lookups per pixel";
    plot.yLabel = "mean shift in pixels";
    plot.keyPosition = "top right";
    for (const SceneMeasurement& m : measurements)
        seriesOf(plot, "", m.technique + (m.skipsHidden ? ", hidden objects skipped" : ""))
            .points.emplace_back(m.fetchesPerPixel, std::max(m.errors.meanShift, 1e-9));
    return plot;
}

void writeScenePicture(const SceneBenchmarkOptions& options, const std::filesystem::path& file) {
    const SceneModel model = sceneModel(options.scene);
    SceneFrames frames(model, options.techniques.front(), options);
    writePicture(file, frames.draw(model.light));
}

}  // namespace relievo::bench
