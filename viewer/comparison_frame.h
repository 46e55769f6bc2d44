#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/framebuffer.h"
#include "reference/error_metrics.h"
#include "viewer/exact_tracker.h"
#include "viewer/scene_renderer.h"
#include "viewer/window_settings.h"

namespace relievo::viewer {

/// What is known of one of the two pictures that a window compares.
struct PaneReadings {
    std::string technique;
    std::string problem;                 ///< why it cannot be shown, or empty
    std::optional<double> milliseconds;  ///< of drawing it, smoothed; not of the exact picture
    std::optional<WorkCounts> work;
    std::optional<reference::ErrorStatistics> errors;  ///< distances in texels
};

/// The picture of a window: one or two techniques, put together as the settings say. It draws to
/// framebuffer objects and needs a current context for its whole life, but no window.
class ComparisonFrame {
  public:
    /// Reads all map files and tries the techniques on the first. Throws textures::InputError.
    explicit ComparisonFrame(const WindowSettings& settings);

    /// Brings the picture up to date with `settings` at a size of `width`×`height` pixels, both
    /// above 0, and follows the view with `tracker`. Returns whether a pane was drawn again, so
    /// that what was measured is out of date. A technique that cannot show the relief leaves its
    /// pane empty and says so in its readings.
    bool update(const WindowSettings& settings, int width, int height, ExactTracker& tracker);

    /// Counts the work of the techniques shown, and their errors when `exact` is the frame of the
    /// exact hits. Without it, on a coarse frame, which is much faster than the picture.
    void measure(const WindowSettings& settings, const ReferenceFrame* exact);

    /// The picture, in attachment 0.
    [[nodiscard]] const gl::Framebuffer& picture() const noexcept { return picture_; }
    [[nodiscard]] const std::array<PaneReadings, 2>& readings() const noexcept { return readings_; }
    /// How many MIP levels the maps of a file have, the first one counted.
    [[nodiscard]] int levelCount(std::size_t file) const {
        return reliefs_.at(file).renderer->levelCount();
    }
    /// Where pane B begins in the picture, in pixels from its left.
    [[nodiscard]] int secondPaneStart() const noexcept { return secondStart_; }

  private:
    struct Relief {
        std::unique_ptr<SceneRenderer> renderer;
        ObjectKind object;
        glm::vec2 tiles;
    };

    void resize(const WindowSettings& settings, int width, int height);
    SceneRenderer& reliefOf(const WindowSettings& settings);
    [[nodiscard]] View viewOf(const WindowSettings& settings) const;
    void redraw(const WindowSettings& settings, const ReferenceFrame* exact);
    void drawPane(std::size_t pane, const std::string& technique, const WindowSettings& settings,
                  const ReferenceFrame* exact);
    void drawHeatMap(const WindowSettings& settings, const ReferenceFrame& exact);
    void compose(const WindowSettings& settings);

    std::vector<Relief> reliefs_;  // one a file
    std::array<gl::Framebuffer, 2> panes_;
    gl::Framebuffer picture_;
    int secondStart_ = 0;
    std::array<PaneReadings, 2> readings_;
    std::optional<WindowSettings> drawn_;  // the settings of the picture
    bool drawnWithExact_ = false;
};

}  // namespace relievo::viewer
