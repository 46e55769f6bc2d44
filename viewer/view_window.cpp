#include "viewer/view_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

#include "viewer/comparison_frame.h"
#include "viewer/control_panel.h"
#include "viewer/exact_tracker.h"
#include "viewer/window_loop.h"
#include "viewer/window_overlay.h"

namespace relievo::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kAnimationPeriod = 4.0;  // seconds from flat to flat
constexpr float kDividerReach = 8.0f;     // pixels around the line that take hold of it

constexpr std::array kKeys = {
    KeyHelp{"1 … 9, ↑ ↓", "technique A of the list"},
    KeyHelp{"0", "the exact picture as A"},
    KeyHelp{"Shift + these", "technique B"},
    KeyHelp{"M", "next comparison: single, side by side, split, error"},
    KeyHelp{"Space", "animate the depth scale"},
    KeyHelp{"left drag on the line", "move it, in a split picture"},
};

class ReliefContent final : public WindowContent {
  public:
    /// The context of the window must be current.
    explicit ReliefContent(const ViewOptions& options)
        : settings_(makeWindowSettings(options)), frame_(settings_), exact_(WindowLoop::wake) {}

    [[nodiscard]] Activity activity() const override {
        if (animation_)
            return Activity::Animation;
        return exact_.isTracing() || exact_.isWaiting() ? Activity::Work : Activity::None;
    }

    void handleKey(const KeyPress& press) override {
        if (chooseTechnique(press))
            return;
        if (press.key == GLFW_KEY_M)
            settings_.mode = static_cast<ComparisonMode>(
                (static_cast<std::size_t>(settings_.mode) + 1) % kComparisonModeNames.size());
        else if (press.key == GLFW_KEY_SPACE)
            toggleAnimation();
    }

    bool handleMouse(const PictureArea& area) override {
        const ImGuiIO& io = ImGui::GetIO();
        if (!ImGui::IsMouseDown(ImGuiMouseButton_Left))
            dividerIsHeld_ = false;
        const float divider = area.left + settings_.split * area.width;
        const bool nearDivider = settings_.mode == ComparisonMode::Split && !io.WantCaptureMouse &&
                                 std::abs(io.MousePos.x - divider) <= kDividerReach;
        if (nearDivider || dividerIsHeld_)
            ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        if (nearDivider && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            dividerIsHeld_ = true;
        if (dividerIsHeld_)
            settings_.split = std::clamp((io.MousePos.x - area.left) / area.width, 0.0f, 1.0f);
        return dividerIsHeld_;
    }

    OrbitCamera& camera() override { return settings_.options.camera; }
    [[nodiscard]] ZoomLimits zoomLimits() const override { return {}; }

    // The depth scale swings between 0 and what it was, beginning there.
    void animate() override {
        if (!animation_)
            return;
        const std::chrono::duration<double> time = Clock::now() - animation_->start;
        const double phase = 2 * std::numbers::pi * time.count() / kAnimationPeriod;
        settings_.options.depthScale =
            static_cast<float>((0.5 + 0.5 * std::cos(phase)) * animation_->depthScale);
    }

    PanelActions drawPanel(const std::string& message, float height) override {
        const float depthScale = settings_.options.depthScale;
        const PanelActions actions =
            drawControlPanel(settings_,
                             {frame_.readings(), frame_.levelCount(settings_.file),
                              exact_.isTracing(), exact_.progress(), message},
                             height);
        // Who takes hold of the depth scale wants it where it was put.
        if (settings_.options.depthScale != depthScale)
            animation_.reset();
        return actions;
    }

    bool update(int width, int height) override {
        return frame_.update(settings_, width, height, exact_);
    }
    void finish() override {}
    void measure() override { frame_.measure(settings_, exact_.frame()); }
    [[nodiscard]] const gl::Framebuffer& picture() const override { return frame_.picture(); }
    void drawOver(const PictureArea& area) override {
        drawOverlay(settings_, area, exact_.isTracing());
    }
    [[nodiscard]] std::span<const KeyHelp> keys() const override { return kKeys; }

  private:
    // 1 … 9 are the first of the list, 0 is the exact picture, the arrows go through the list; with
    // Shift for B. Returns whether it is one of these keys.
    bool chooseTechnique(const KeyPress& press) {
        const auto choices = techniqueChoices();
        std::string& technique =
            (press.modifiers & GLFW_MOD_SHIFT) != 0 ? settings_.techniqueB : settings_.techniqueA;
        const auto current =
            static_cast<std::size_t>(std::ranges::find(choices, technique) - choices.begin());
        std::size_t chosen = current;
        if (press.key == GLFW_KEY_0)
            chosen = choices.size() - 1;
        else if (press.key >= GLFW_KEY_1 && press.key <= GLFW_KEY_9)
            chosen = static_cast<std::size_t>(press.key - GLFW_KEY_1);
        else if (press.key == GLFW_KEY_DOWN)
            chosen = (current + 1) % choices.size();
        else if (press.key == GLFW_KEY_UP)
            chosen = (current + choices.size() - 1) % choices.size();
        else
            return false;
        if (chosen < choices.size())
            technique = choices[chosen];
        return true;
    }

    void toggleAnimation() {
        if (animation_)
            settings_.options.depthScale = animation_->depthScale;
        if (animation_)
            animation_.reset();
        else
            animation_ = Animation{Clock::now(), settings_.options.depthScale};
    }

    struct Animation {
        Clock::time_point start;
        float depthScale;  // at the start
    };

    WindowSettings settings_;
    ComparisonFrame frame_;
    ExactTracker exact_;  // after frame_, whose depth maps its thread reads
    std::optional<Animation> animation_;
    bool dividerIsHeld_ = false;
};

}  // namespace

void runWindow(const ViewOptions& options) {
    WindowLoop loop(options);
    ReliefContent content(options);
    loop.run(content);
}

}  // namespace relievo::viewer
