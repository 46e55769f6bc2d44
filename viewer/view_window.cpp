#include "viewer/view_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "commands/program.h"
#include "gl/glfw_context.h"
#include "textures/input_error.h"
#include "viewer/comparison_frame.h"
#include "viewer/control_panel.h"
#include "viewer/exact_tracker.h"
#include "viewer/imgui_session.h"
#include "viewer/orbit_control.h"
#include "viewer/picture.h"
#include "viewer/window_overlay.h"

namespace relievo::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kMeasureInterval{300};
constexpr double kTick = 0.05;  // seconds, while something is under way
constexpr double kAnimationTick = 1 / 60.0;
constexpr double kIdleTick = 60.0;
constexpr double kAnimationPeriod = 4.0;  // seconds from flat to flat
constexpr float kDividerReach = 8.0f;     // pixels around the line that take hold of it
// After an event ImGui needs some frames until all widgets show its consequences: a list opens on
// the release of the button, one frame after the press, and hides until its size is known.
constexpr int kFramesToSettle = 8;

struct KeyPress {
    int key;
    int modifiers;
};

// What GLFW told since the last frame.
struct WindowEvents {
    bool any = true;  // the first frame needs no event
    std::vector<KeyPress> keys;
};

WindowEvents& eventsOf(GLFWwindow* window) {
    return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

template <typename... Arguments>
void noteEvent(GLFWwindow* window, Arguments...) {
    eventsOf(window).any = true;
}

void noteKey(GLFWwindow* window, int key, int, int action, int modifiers) {
    eventsOf(window).any = true;
    if (action == GLFW_PRESS)
        eventsOf(window).keys.push_back({key, modifiers});
}

void watchEvents(GLFWwindow* window, WindowEvents& events) {
    glfwSetWindowUserPointer(window, &events);
    glfwSetKeyCallback(window, noteKey);
    glfwSetCharCallback(window, noteEvent<unsigned>);
    glfwSetMouseButtonCallback(window, noteEvent<int, int, int>);
    glfwSetCursorPosCallback(window, noteEvent<double, double>);
    glfwSetCursorEnterCallback(window, noteEvent<int>);
    glfwSetScrollCallback(window, noteEvent<double, double>);
    glfwSetFramebufferSizeCallback(window, noteEvent<int, int>);
    glfwSetWindowFocusCallback(window, noteEvent<int>);
    glfwSetWindowRefreshCallback(window, noteEvent<>);
    glfwSetWindowCloseCallback(window, noteEvent<>);
}

std::unique_ptr<gl::Context> openWindow(const ViewOptions& options) {
    gl::ContextOptions window;
    window.width = options.width + kPanelWidth;
    window.height = options.height;
    window.title = "Relievo: " + options.files.front().filename().string();
    try {
        return gl::createContext(gl::Backend::Glfw, window);
    } catch (const gl::GlError& error) {
        throw gl::GlError(fmt::format("{} (--headless -o FILE needs no display)", error.what()));
    }
}

class ViewWindow {
  public:
    explicit ViewWindow(const ViewOptions& options)
        : context_(openWindow(options)),
          window_(static_cast<gl::GlfwContext&>(*context_).window()),
          settings_(makeWindowSettings(options)),
          frame_(settings_),
          exact_(glfwPostEmptyEvent),
          firstCamera_(options.camera) {
        watchEvents(window_, events_);
        imgui_ = std::make_unique<ImGuiSession>(window_);
        glfwSwapInterval(1);
    }

    void run() {
        while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
            if (isEventful() || waitForWork())
                showFrame();
        }
    }

  private:
    // Whether the next frame would differ from the last one for a reason known already.
    [[nodiscard]] bool isEventful() {
        glfwPollEvents();
        if (std::exchange(events_.any, false))
            framesToSettle_ = kFramesToSettle;
        return framesToSettle_ > 0;
    }

    // Sleeps until there may be something to show; returns whether there is.
    bool waitForWork() {
        const bool working = exact_.isTracing() || exact_.isWaiting() || measurementIsDue_;
        glfwWaitEventsTimeout(animation_ ? kAnimationTick : working ? kTick : kIdleTick);
        return working || animation_;
    }

    void showFrame() {
        framesToSettle_ = std::max(0, framesToSettle_ - 1);
        int width = 0;
        int height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        imgui_->begin();
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        const float left = panelIsShown_ ? static_cast<float>(kPanelWidth) : 0.0f;
        const PictureArea area{left, size.x - left, size.y};
        if (area.width >= 1.0f && area.height >= 1.0f) {
            handleKeys();
            handleMouse(area);
            animate();
            showPanel(size.y);
            showPicture(area, width, height);
        }
        imgui_->end();
        glfwSwapBuffers(window_);
    }

    void handleKeys() {
        for (const KeyPress& press : std::exchange(events_.keys, {}))
            if (!ImGui::GetIO().WantTextInput)
                handleKey(press);
    }

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

    void handleKey(const KeyPress& press) {
        if (chooseTechnique(press))
            return;
        switch (press.key) {
            case GLFW_KEY_M:
                settings_.mode = static_cast<ComparisonMode>(
                    (static_cast<std::size_t>(settings_.mode) + 1) % kComparisonModeNames.size());
                break;
            case GLFW_KEY_SPACE:
                toggleAnimation();
                break;
            case GLFW_KEY_S:
                savePicture();
                break;
            case GLFW_KEY_R:
                settings_.options.camera = firstCamera_;
                break;
            case GLFW_KEY_H:
                panelIsShown_ = !panelIsShown_;
                break;
            case GLFW_KEY_F1:
                helpIsShown_ = !helpIsShown_;
                break;
            case GLFW_KEY_Q:
            case GLFW_KEY_ESCAPE:
                glfwSetWindowShouldClose(window_, GLFW_TRUE);
                break;
            default:
                break;
        }
    }

    void handleMouse(const PictureArea& area) {
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
        else if (!io.WantCaptureMouse)
            moveCamera(io, area.height);
    }

    void moveCamera(const ImGuiIO& io, float height) {
        OrbitCamera& camera = settings_.options.camera;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
            camera = firstCamera_;
        else if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0f))
            camera = orbited(camera, io.MouseDelta.x, io.MouseDelta.y, height);
        else if (ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0.0f) ||
                 ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0f))
            camera = panned(camera, io.MouseDelta.x, io.MouseDelta.y, height);
        if (io.MouseWheel != 0.0f)
            camera = zoomed(camera, io.MouseWheel);
    }

    void toggleAnimation() {
        if (animation_)
            settings_.options.depthScale = animation_->depthScale;
        if (animation_)
            animation_.reset();
        else
            animation_ = Animation{Clock::now(), settings_.options.depthScale};
    }

    // The depth scale swings between 0 and what it was, beginning there.
    void animate() {
        if (!animation_)
            return;
        const std::chrono::duration<double> time = Clock::now() - animation_->start;
        const double phase = 2 * std::numbers::pi * time.count() / kAnimationPeriod;
        settings_.options.depthScale =
            static_cast<float>((0.5 + 0.5 * std::cos(phase)) * animation_->depthScale);
    }

    void showPanel(float height) {
        if (!panelIsShown_)
            return;
        const float depthScale = settings_.options.depthScale;
        const PanelActions actions =
            drawControlPanel(settings_,
                             {frame_.readings(), frame_.levelCount(settings_.file),
                              exact_.isTracing(), exact_.progress(), message_},
                             height);
        // Who takes hold of the depth scale wants it where it was put.
        if (settings_.options.depthScale != depthScale)
            animation_.reset();
        if (actions.save)
            savePicture();
        if (actions.resetCamera)
            settings_.options.camera = firstCamera_;
        if (actions.help)
            helpIsShown_ = !helpIsShown_;
    }

    void showPicture(const PictureArea& area, int windowWidth, int windowHeight) {
        // The framebuffer has more pixels than the window where the window system scales.
        const float scale = static_cast<float>(windowHeight) / area.height;
        const int left = static_cast<int>(std::lround(scale * area.left));
        const int width = std::max(1, windowWidth - left);
        if (frame_.update(settings_, width, windowHeight, exact_))
            measurementIsDue_ = true;
        measure();
        glBlitNamedFramebuffer(frame_.picture().id(), 0, 0, 0, width, windowHeight, left, 0,
                               left + width, windowHeight, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, windowWidth, windowHeight);
        drawOverlay(settings_, area, exact_.isTracing());
        if (helpIsShown_)
            drawHelp(area);
    }

    void measure() {
        if (!measurementIsDue_ || Clock::now() - lastMeasured_ < kMeasureInterval)
            return;
        frame_.measure(settings_, exact_.frame());
        measurementIsDue_ = false;
        lastMeasured_ = Clock::now();
        framesToSettle_ = kFramesToSettle;  // the panel of this frame is drawn already
    }

    void savePicture() {
        try {
            const std::filesystem::path file = nextPictureName(".");
            Picture picture(frame_.picture().width(), frame_.picture().height());
            picture.rgba = frame_.picture().read(0);
            writePicture(file, picture);
            message_ = "saved " + file.filename().string();
            commands::say("wrote " + file.filename().string());
        } catch (const textures::InputError& error) {
            message_ = error.what();
        }
    }

    struct Animation {
        Clock::time_point start;
        float depthScale;  // at the start
    };

    std::unique_ptr<gl::Context> context_;
    GLFWwindow* window_;
    WindowEvents events_;
    std::unique_ptr<ImGuiSession> imgui_;
    WindowSettings settings_;
    ComparisonFrame frame_;
    ExactTracker exact_;  // after frame_, whose depth maps its thread reads
    OrbitCamera firstCamera_;
    std::optional<Animation> animation_;
    bool panelIsShown_ = true;
    bool helpIsShown_ = false;
    bool dividerIsHeld_ = false;
    bool measurementIsDue_ = true;
    Clock::time_point lastMeasured_;
    int framesToSettle_ = kFramesToSettle;
    std::string message_;
};

}  // namespace

std::filesystem::path nextPictureName(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        std::filesystem::path file = folder / fmt::format("view-{:03}.png", number);
        if (!std::filesystem::exists(std::filesystem::symlink_status(file)))
            return file;
    }
}

void runWindow(const ViewOptions& options) {
    ViewWindow(options).run();
}

}  // namespace relievo::viewer
