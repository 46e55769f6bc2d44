#pragma once

#include <memory>
#include <optional>
#include <string>

#include "gl/framebuffer.h"
#include "viewer/solid_session.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// What is known of the picture of a scene or a shape.
struct SolidReadings {
    std::string problem;                 ///< why it cannot be shown, or empty
    std::optional<double> milliseconds;  ///< of drawing it, smoothed
    std::optional<WorkCounts> work;      ///< of a shape
};

/// The picture of a scene or a shape as the options have it, which may change: the first of
/// options.techniques shows it. It draws to a framebuffer object and needs a current context for
/// its whole life, but no window.
class SolidFrame {
  public:
    /// Opens options.files.front(). Throws textures::InputError.
    explicit SolidFrame(const ViewOptions& options);

    /// Brings the picture up to date at a size of `width`×`height` pixels, both above 0. Returns
    /// whether it was drawn again. Options that cannot be shown leave the picture empty and say so
    /// in the readings.
    bool update(const ViewOptions& options, int width, int height);

    /// Counts the work of the searches of a shape, on a coarse frame.
    void measure();

    /// The picture, in attachment 0.
    [[nodiscard]] const gl::Framebuffer& picture() const noexcept { return picture_; }
    [[nodiscard]] const SolidReadings& readings() const noexcept { return readings_; }
    [[nodiscard]] const SolidSession& session() const noexcept { return *session_; }

  private:
    void redraw(const ViewOptions& options);
    void drawTimed(const ViewOptions& options);

    std::unique_ptr<SolidSession> session_;
    gl::Framebuffer picture_;
    SolidReadings readings_;
    std::optional<ViewOptions> drawn_;  // the options of the picture
};

}  // namespace relievo::viewer
