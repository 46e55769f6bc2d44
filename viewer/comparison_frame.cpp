#include "viewer/comparison_frame.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "textures/input_error.h"
#include "viewer/carrier_mesh.h"
#include "viewer/error_image.h"
#include "viewer/heat_map.h"
#include "viewer/view_session.h"

namespace relievo::viewer {
namespace {

constexpr int kPaneGap = 2;
// Counting work on every fourth pixel of every fourth row is enough for means.
constexpr int kCoarseness = 4;
// The share of the newest frame in the smoothed time.
constexpr double kNewest = 0.2;
constexpr int kWidestScale = 480;
constexpr int kNarrowestScale = 300;

std::array<GLenum, 1> pictureFormat() {
    return {GL_RGBA8};
}

// Copies the columns [from, from + width) of `source` to the same rows of `target`, from column
// `to`.
void copyColumns(const gl::Framebuffer& source, const gl::Framebuffer& target, int from, int to,
                 int width) {
    glBlitNamedFramebuffer(source.id(), target.id(), from, 0, from + width, source.height(), to, 0,
                           to + width, target.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

// Puts `source` into `target` with its lower left corner at the lower left of the target.
void putPicture(const gl::Framebuffer& target, const Picture& source) {
    Picture turned(source.width, source.height);
    for (int y = 0; y < source.height; ++y)
        std::copy_n(source.pixel(0, y), 4 * source.width, turned.pixel(0, source.height - 1 - y));
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(target.color(0).id(), 0, 0, 0, source.width, source.height, GL_RGBA,
                        GL_FLOAT, turned.rgba.data());
}

void drawTechnique(SceneRenderer& renderer, const std::string& name, const ViewOptions& options,
                   const View& view, const ReferenceFrame* exact, gl::Framebuffer& target) {
    if (name == kReferenceName && exact) {
        renderer.drawReference(*exact, view, target);
        return;
    }
    // Until the exact hits are known, normal mapping stands in for them.
    const materials::Technique& technique =
        materials::findTechnique(name == kReferenceName ? "normal" : name);
    materials::ReliefMaterial material = makeConfiguredMaterial(renderer, technique, options);
    renderer.draw(material, view, target);
}

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

std::optional<RayKey::Light> lightKey(const ViewOptions& options) {
    if (options.shadow == kNoShadow)
        return std::nullopt;
    return RayKey::Light{options.light, options.lightSize};
}

RayKey rayKey(const WindowSettings& settings, const gl::Framebuffer& pane) {
    return {settings.file,
            settings.options.object,
            settings.options.tiles,
            settings.options.depthScale,
            settings.options.camera,
            lightKey(settings.options),
            pane.width(),
            pane.height()};
}

// Whether the two panes are the same: the other settings change only what is measured and how the
// panes are put together.
bool samePanes(WindowSettings a, const WindowSettings& b) {
    a.measureErrors = b.measureErrors;
    a.split = b.split;
    return a == b;
}

}  // namespace

ComparisonFrame::ComparisonFrame(const WindowSettings& settings) {
    const ViewOptions& options = settings.options;
    for (const std::filesystem::path& file : options.files)
        reliefs_.push_back({openRelief(file, options), options.object, options.tiles});
    // Normal mapping gives the rays of the exact hits: without its maps a file cannot be shown.
    for (const Relief& relief : reliefs_)
        relief.renderer->makeMaterial(materials::findTechnique("normal"));
    for (const std::string& name : options.techniques)
        if (name != kReferenceName)
            makeConfiguredMaterial(*reliefs_[0].renderer, materials::findTechnique(name), options);
}

bool ComparisonFrame::update(const WindowSettings& settings, int width, int height,
                             ExactTracker& tracker) {
    const bool resized = picture_.width() != width || picture_.height() != height || !drawn_ ||
                         drawn_->mode != settings.mode;
    if (resized)
        resize(settings, width, height);
    tracker.follow(rayKey(settings, panes_[0]), viewOf(settings), reliefOf(settings),
                   needsReference(settings));
    const ReferenceFrame* exact = tracker.frame();
    const bool redrawn =
        resized || !samePanes(*drawn_, settings) || drawnWithExact_ != (exact != nullptr);
    if (redrawn)
        redraw(settings, exact);
    if (redrawn || drawn_->split != settings.split)
        compose(settings);
    drawn_ = settings;
    drawnWithExact_ = exact != nullptr;
    return redrawn;
}

void ComparisonFrame::resize(const WindowSettings& settings, int width, int height) {
    int paneWidth = width;
    secondStart_ = 0;
    if (settings.mode == ComparisonMode::SideBySide) {
        paneWidth = std::max(1, (width - kPaneGap) / 2);
        secondStart_ = width - paneWidth;
    }
    if (picture_.width() != width || picture_.height() != height)
        picture_ = gl::Framebuffer(width, height, pictureFormat());
    for (gl::Framebuffer& pane : panes_)
        if (pane.width() != paneWidth || pane.height() != height)
            pane = gl::Framebuffer(paneWidth, height, pictureFormat());
    for (PaneReadings& readings : readings_)
        readings = {};
}

SceneRenderer& ComparisonFrame::reliefOf(const WindowSettings& settings) {
    Relief& relief = reliefs_.at(settings.file);
    const ViewOptions& options = settings.options;
    if (relief.object != options.object || relief.tiles != options.tiles) {
        relief.renderer->setSurface(
            makeCarrier(options, static_cast<float>(relief.renderer->depthMap().aspect())));
        relief.object = options.object;
        relief.tiles = options.tiles;
    }
    return *relief.renderer;
}

View ComparisonFrame::viewOf(const WindowSettings& settings) const {
    return makeView(settings.options,
                    static_cast<float>(panes_[0].width()) / static_cast<float>(panes_[0].height()));
}

void ComparisonFrame::redraw(const WindowSettings& settings, const ReferenceFrame* exact) {
    drawPane(0, settings.techniqueA, settings, exact);
    if (showsSecond(settings))
        drawPane(1, settings.techniqueB, settings, exact);
    if (settings.mode == ComparisonMode::HeatMap && exact && readings_[0].problem.empty())
        drawHeatMap(settings, *exact);
}

void ComparisonFrame::drawPane(std::size_t pane, const std::string& technique,
                               const WindowSettings& settings, const ReferenceFrame* exact) {
    SceneRenderer& renderer = reliefOf(settings);
    const View view = viewOf(settings);
    PaneReadings& readings = readings_[pane];
    const auto draw = [&] {
        drawTechnique(renderer, technique, settings.options, view, exact, panes_[pane]);
        glFinish();
    };
    try {
        if (readings.technique != technique) {
            readings = {};
            readings.technique = technique;
            draw();  // untimed: it may have to compile the program and upload maps
        }
        const auto start = std::chrono::steady_clock::now();
        draw();
        const double time = millisecondsSince(start);
        if (technique != kReferenceName)
            readings.milliseconds =
                readings.milliseconds ? std::lerp(*readings.milliseconds, time, kNewest) : time;
        readings.problem.clear();
    } catch (const textures::InputError& error) {
        readings = {};
        readings.technique = technique;
        readings.problem = error.what();
        panes_[pane].clearColor(0, 0.09f, 0.09f, 0.1f, 1.0f);
    }
}

void ComparisonFrame::drawHeatMap(const WindowSettings& settings, const ReferenceFrame& exact) {
    if (settings.techniqueA == kReferenceName)
        return;
    SceneRenderer& renderer = reliefOf(settings);
    materials::ReliefMaterial material = makeConfiguredMaterial(
        renderer, materials::findTechnique(settings.techniqueA), settings.options);
    const View view = viewOf(settings);
    const MeasuredFrame frame = renderer.measure(material, view, exact.width, exact.height);
    const ErrorImage errors = makeErrorImage(frame, exact, renderer.depthMap(), view.depthScale);
    putPicture(panes_[0], heatMap(errors));
    if (exact.width >= kNarrowestScale && exact.height >= 2 * kHeatScaleHeight)
        putPicture(panes_[0], heatScale(std::min(exact.width, kWidestScale)));
}

void ComparisonFrame::compose(const WindowSettings& settings) {
    const int width = picture_.width();
    picture_.clearColor(0, 0.0f, 0.0f, 0.0f, 1.0f);
    if (settings.mode == ComparisonMode::SideBySide) {
        copyColumns(panes_[0], picture_, 0, 0, panes_[0].width());
        copyColumns(panes_[1], picture_, 0, secondStart_, panes_[1].width());
    } else if (settings.mode == ComparisonMode::Split) {
        secondStart_ = static_cast<int>(std::lround(settings.split * static_cast<float>(width)));
        copyColumns(panes_[0], picture_, 0, 0, secondStart_);
        copyColumns(panes_[1], picture_, secondStart_, secondStart_, width - secondStart_);
    } else {
        copyColumns(panes_[0], picture_, 0, 0, width);
    }
}

void ComparisonFrame::measure(const WindowSettings& settings, const ReferenceFrame* exact) {
    SceneRenderer& renderer = reliefOf(settings);
    const View view = viewOf(settings);
    const std::size_t shown = showsSecond(settings) ? 2 : 1;
    for (std::size_t pane = 0; pane < shown; ++pane) {
        PaneReadings& readings = readings_[pane];
        readings.work.reset();
        readings.errors.reset();
        if (!readings.problem.empty() || readings.technique == kReferenceName)
            continue;
        materials::ReliefMaterial material = makeConfiguredMaterial(
            renderer, materials::findTechnique(readings.technique), settings.options);
        const int divisor = exact ? 1 : kCoarseness;
        const MeasuredFrame frame =
            renderer.measure(material, view, std::max(1, panes_[pane].width() / divisor),
                             std::max(1, panes_[pane].height() / divisor));
        readings.work = countWork(frame);
        if (exact) {
            const double texel = 1.0 / renderer.depthMap().width();
            readings.errors = reference::summarizeErrors(
                compareFrames(frame, *exact, renderer.depthMap(), view.depthScale), texel);
            readings.errors->meanDistance /= texel;
            readings.errors->percentile99Distance /= texel;
            readings.errors->maximumDistance /= texel;
        }
    }
}

}  // namespace relievo::viewer
