#pragma once

#include <chrono>
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
/// options.techniques shows it. It is drawn object by object, so that a window may answer in
/// between. It draws to a framebuffer object and needs a current context for its whole life, but no
/// window.
class SolidFrame {
  public:
    /// Opens options.files.front(). Throws textures::InputError.
    explicit SolidFrame(const ViewOptions& options,
                        std::chrono::milliseconds patience = std::chrono::milliseconds(50));

    /// Works on the picture of a size of `width`×`height` pixels, both above 0, until it is
    /// finished or the patience is at its end, at least on one object. Returns whether it became
    /// finished. Options that cannot be shown leave the picture empty and say so in the
    /// readings.
    ///
    /// Until then the picture is the last one, or, where it would be of another size or seen from
    /// elsewhere, a draft of few pixels; before the first one, whose programs have to be compiled,
    /// what is drawn of it, and the surfaces that the other solids are in.
    bool update(const ViewOptions& options, int width, int height);
    /// Does the rest of that work. Returns whether there was any.
    bool finish();
    /// How far the picture is that update() works on, or nothing when it is finished.
    [[nodiscard]] std::optional<SolidProgress> progress() const;

    /// Counts the work of the searches of a shape, on a coarse frame.
    void measure();

    /// The picture, in attachment 0.
    [[nodiscard]] const gl::Framebuffer& picture() const noexcept { return picture_; }
    [[nodiscard]] const SolidReadings& readings() const noexcept { return readings_; }
    [[nodiscard]] const SolidSession& session() const noexcept { return *session_; }

  private:
    bool isOf(const ViewOptions& options, int width, int height) const;
    void begin(const ViewOptions& options, int width, int height);
    void step();
    void showDraft();
    void showNext();
    void fail(const std::string& problem);

    std::chrono::milliseconds patience_;
    std::unique_ptr<SolidSession> session_;
    gl::Framebuffer picture_;
    gl::Framebuffer next_;                  // what is drawn
    std::optional<ViewOptions> asked_;      // the options of next_, or of picture_ when finished
    std::optional<OrbitCamera> shownFrom_;  // of picture_
    bool isFinished_ = true;
    bool hasPrograms_ = false;  // a picture of the session is finished
    double spent_ = 0.0;        // milliseconds on next_
    SolidReadings readings_;
};

}  // namespace relievo::viewer
