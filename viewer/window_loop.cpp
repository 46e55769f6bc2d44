#include "viewer/window_loop.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "commands/program.h"
#include "gl/glfw_context.h"
#include "textures/input_error.h"
#include "viewer/picture.h"
#include "viewer/window_overlay.h"

namespace relievo::viewer {
namespace {

constexpr std::chrono::milliseconds kMeasureInterval{300};
constexpr double kTick = 0.05;  // seconds, while something is under way
constexpr double kAnimationTick = 1 / 60.0;
constexpr double kIdleTick = 60.0;

// Seconds until something may have changed without an event.
double tickOf(WindowContent::Activity activity) {
    switch (activity) {
        case WindowContent::Activity::None:
            return kIdleTick;
        case WindowContent::Activity::Work:
            return kTick;
        case WindowContent::Activity::Animation:
            return kAnimationTick;
        case WindowContent::Activity::Drawing:
            return 0.0;
    }
    return kIdleTick;
}

// After an event ImGui needs some frames until all widgets show its consequences: a list opens on
// the release of the button, one frame after the press, and hides until its size is known.
constexpr int kFramesToSettle = 8;

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

}  // namespace

WindowLoop::Events& WindowLoop::eventsOf(GLFWwindow* window) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(window));
}

template <typename... Arguments>
void WindowLoop::noteEvent(GLFWwindow* window, Arguments...) {
    eventsOf(window).any = true;
}

void WindowLoop::noteKey(GLFWwindow* window, int key, int, int action, int modifiers) {
    eventsOf(window).any = true;
    if (action == GLFW_PRESS)
        eventsOf(window).keys.push_back({key, modifiers});
}

void WindowLoop::watchEvents() {
    glfwSetWindowUserPointer(window_, &events_);
    glfwSetKeyCallback(window_, noteKey);
    glfwSetCharCallback(window_, noteEvent<unsigned>);
    glfwSetMouseButtonCallback(window_, noteEvent<int, int, int>);
    glfwSetCursorPosCallback(window_, noteEvent<double, double>);
    glfwSetCursorEnterCallback(window_, noteEvent<int>);
    glfwSetScrollCallback(window_, noteEvent<double, double>);
    glfwSetFramebufferSizeCallback(window_, noteEvent<int, int>);
    glfwSetWindowFocusCallback(window_, noteEvent<int>);
    glfwSetWindowRefreshCallback(window_, noteEvent<>);
    glfwSetWindowCloseCallback(window_, noteEvent<>);
}

WindowLoop::WindowLoop(const ViewOptions& options)
    : context_(openWindow(options)),
      window_(static_cast<gl::GlfwContext&>(*context_).window()),
      framesToSettle_(kFramesToSettle) {
    watchEvents();
    imgui_ = std::make_unique<ImGuiSession>(window_);
    glfwSwapInterval(1);
}

WindowLoop::~WindowLoop() = default;

void WindowLoop::wake() {
    glfwPostEmptyEvent();
}

void WindowLoop::announce(const char* note) {
    glfwPollEvents();
    imgui_->begin();
    glClear(GL_COLOR_BUFFER_BIT);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    drawNote(note, {0.0f, size.x, size.y});
    imgui_->end();
    glfwSwapBuffers(window_);
}

void WindowLoop::run(WindowContent& content) {
    firstCamera_ = content.camera();
    while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
        if (isEventful() || waitForWork(content))
            showFrame(content);
    }
}

// Whether the next frame would differ from the last one for a reason known already.
bool WindowLoop::isEventful() {
    glfwPollEvents();
    if (std::exchange(events_.any, false))
        framesToSettle_ = kFramesToSettle;
    return framesToSettle_ > 0;
}

// Sleeps until there may be something to show; returns whether there is.
bool WindowLoop::waitForWork(const WindowContent& content) const {
    WindowContent::Activity activity = content.activity();
    if (activity == WindowContent::Activity::None && measurementIsDue_)
        activity = WindowContent::Activity::Work;
    glfwWaitEventsTimeout(tickOf(activity));
    return activity != WindowContent::Activity::None;
}

void WindowLoop::showFrame(WindowContent& content) {
    framesToSettle_ = std::max(0, framesToSettle_ - 1);
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    imgui_->begin();
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float left = panelIsShown_ ? static_cast<float>(kPanelWidth) : 0.0f;
    const PictureArea area{left, size.x - left, size.y};
    if (area.width >= 1.0f && area.height >= 1.0f) {
        handleKeys(content);
        if (!content.handleMouse(area) && !ImGui::GetIO().WantCaptureMouse)
            moveCamera(content, area.height);
        content.animate();
        showPanel(content, size.y);
        showPicture(content, area, width, height);
    }
    imgui_->end();
    glfwSwapBuffers(window_);
}

void WindowLoop::handleKeys(WindowContent& content) {
    for (const KeyPress& press : std::exchange(events_.keys, {}))
        if (!ImGui::GetIO().WantTextInput)
            handleKey(content, press);
}

void WindowLoop::handleKey(WindowContent& content, const KeyPress& press) {
    switch (press.key) {
        case GLFW_KEY_S:
            savePicture(content);
            break;
        case GLFW_KEY_R:
            content.camera() = firstCamera_;
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
            content.handleKey(press);
            break;
    }
}

void WindowLoop::moveCamera(WindowContent& content, float height) const {
    const ImGuiIO& io = ImGui::GetIO();
    OrbitCamera& camera = content.camera();
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        camera = firstCamera_;
    else if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0f))
        camera = orbited(camera, io.MouseDelta.x, io.MouseDelta.y, height);
    else if (ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0.0f) ||
             ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0f))
        camera = panned(camera, io.MouseDelta.x, io.MouseDelta.y, height);
    if (io.MouseWheel != 0.0f)
        camera = zoomed(camera, io.MouseWheel, content.zoomLimits());
}

void WindowLoop::showPanel(WindowContent& content, float height) {
    if (!panelIsShown_)
        return;
    const PanelActions actions = content.drawPanel(message_, height);
    if (actions.save)
        savePicture(content);
    if (actions.resetCamera)
        content.camera() = firstCamera_;
    if (actions.help)
        helpIsShown_ = !helpIsShown_;
}

void WindowLoop::showPicture(WindowContent& content, const PictureArea& area, int windowWidth,
                             int windowHeight) {
    // The framebuffer has more pixels than the window where the window system scales.
    const float scale = static_cast<float>(windowHeight) / area.height;
    const int left = static_cast<int>(std::lround(scale * area.left));
    const int width = std::max(1, windowWidth - left);
    if (content.update(width, windowHeight))
        measurementIsDue_ = true;
    measure(content);
    glBlitNamedFramebuffer(content.picture().id(), 0, 0, 0, width, windowHeight, left, 0,
                           left + width, windowHeight, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, windowWidth, windowHeight);
    content.drawOver(area);
    if (helpIsShown_)
        drawHelp(area, content.keys());
}

void WindowLoop::measure(WindowContent& content) {
    if (!measurementIsDue_ || Clock::now() - lastMeasured_ < kMeasureInterval)
        return;
    content.measure();
    measurementIsDue_ = false;
    lastMeasured_ = Clock::now();
    framesToSettle_ = kFramesToSettle;  // the panel of this frame is drawn already
}

void WindowLoop::savePicture(WindowContent& content) {
    content.finish();
    try {
        const std::filesystem::path file = nextPictureName(".");
        const gl::Framebuffer& shown = content.picture();
        Picture picture(shown.width(), shown.height());
        picture.rgba = shown.read(0);
        writePicture(file, picture);
        message_ = "saved " + file.filename().string();
        commands::say("wrote " + file.filename().string());
    } catch (const textures::InputError& error) {
        message_ = error.what();
    }
}

std::filesystem::path nextPictureName(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        std::filesystem::path file = folder / fmt::format("view-{:03}.png", number);
        if (!std::filesystem::exists(std::filesystem::symlink_status(file)))
            return file;
    }
}

}  // namespace relievo::viewer
