#include "viewer/solid_window.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "viewer/solid_frame.h"
#include "viewer/solid_headless.h"
#include "viewer/solid_panel.h"
#include "viewer/tessellation_count.h"
#include "viewer/window_loop.h"
#include "viewer/window_overlay.h"

namespace relievo::viewer {
namespace {

std::string noteOf(const SolidProgress& progress) {
    return fmt::format("{} {} of {}…", progress.isOfShadows ? "shadows" : "objects", progress.done,
                       progress.count);
}

class SolidContent final : public WindowContent {
  public:
    /// The context of the window must be current.
    explicit SolidContent(const ViewOptions& options) : options_(options), frame_(options) {
        if (const auto& scene = frame_.session().scene()) {
            takeSceneView(*scene, options_);
            triangles_ = countTriangles(*scene);
        }
        zoomLimits_ = zoomLimitsAround(options_.camera);
    }

    [[nodiscard]] Activity activity() const override {
        return frame_.progress() ? Activity::Drawing : Activity::None;
    }
    void handleKey(const KeyPress&) override {}
    bool handleMouse(const PictureArea&) override { return false; }
    OrbitCamera& camera() override { return options_.camera; }
    [[nodiscard]] ZoomLimits zoomLimits() const override { return zoomLimits_; }
    void animate() override {}

    PanelActions drawPanel(const std::string& message, float height) override {
        return drawSolidPanel(
            options_, {frame_.readings(), frame_.session().shape(), triangles_, message}, height);
    }

    bool update(int width, int height) override { return frame_.update(options_, width, height); }
    void finish() override { frame_.finish(); }
    void measure() override { frame_.measure(); }
    [[nodiscard]] const gl::Framebuffer& picture() const override { return frame_.picture(); }
    void drawOver(const PictureArea& area) override {
        if (const auto progress = frame_.progress())
            drawNote(noteOf(*progress).c_str(), area);
    }
    [[nodiscard]] std::span<const KeyHelp> keys() const override { return {}; }

  private:
    ViewOptions options_;
    SolidFrame frame_;
    std::optional<SceneTriangles> triangles_;
    ZoomLimits zoomLimits_;
};

}  // namespace

void runSolidWindow(const ViewOptions& options) {
    checkSolidOptions(options);
    WindowLoop loop(options);
    loop.announce("opening…");
    SolidContent content(options);
    loop.run(content);
}

}  // namespace relievo::viewer
