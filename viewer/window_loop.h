#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gl/context.h"
#include "gl/framebuffer.h"
#include "viewer/camera.h"
#include "viewer/imgui_session.h"
#include "viewer/orbit_control.h"
#include "viewer/panel_layout.h"
#include "viewer/view_options.h"
#include "viewer/window_help.h"

struct GLFWwindow;

namespace relievo::viewer {

struct KeyPress {
    int key;        ///< GLFW_KEY_…
    int modifiers;  ///< GLFW_MOD_…
};

/// What a window shows: a picture, and a panel beside it. The functions are called within a frame
/// of ImGui, in the order in which they stand here.
class WindowContent {
  public:
    virtual ~WindowContent() = default;

    /// What a window does without being touched.
    enum class Activity {
        None,
        Work,       ///< something is under way that the picture or the panel waits for
        Animation,  ///< the picture moves
        Drawing     ///< update() has more to do on the picture
    };
    [[nodiscard]] virtual Activity activity() const = 0;

    /// Answers a key that is not one of the window's own.
    virtual void handleKey(const KeyPress& press) = 0;
    /// Whether the pointer moves something in the picture; else it moves the camera.
    virtual bool handleMouse(const PictureArea& area) = 0;
    /// The eye, which the mouse moves. How it is before the first frame is where a reset goes.
    virtual OrbitCamera& camera() = 0;
    [[nodiscard]] virtual ZoomLimits zoomLimits() const = 0;
    /// Goes on with what moves by itself.
    virtual void animate() = 0;
    /// Draws the panel, `height` pixels high. `message` is about the last picture saved, or empty.
    virtual PanelActions drawPanel(const std::string& message, float height) = 0;
    /// Brings the picture up to date at that size in pixels. Returns whether what was measured is
    /// out of date.
    virtual bool update(int width, int height) = 0;
    /// Has the picture finished that is saved, if update() had more to do on it.
    virtual void finish() = 0;
    /// Measures what the picture shows, for the panel.
    virtual void measure() = 0;
    [[nodiscard]] virtual const gl::Framebuffer& picture() const = 0;
    /// Draws what lies over the picture.
    virtual void drawOver(const PictureArea& area) = 0;
    /// The keys that the help lists besides the window's own.
    [[nodiscard]] virtual std::span<const KeyHelp> keys() const = 0;
};

/// A window with a panel and a picture: its events, its own keys (S saves, R resets the view, H
/// hides the panel, F1 is help, Q and Esc close it), the mouse, and a picture that is drawn when
/// there is a reason.
class WindowLoop {
  public:
    /// Opens a window with room for the panel and a picture of the size that `options` ask for, and
    /// makes its context current. Throws gl::GlError when there is no display.
    explicit WindowLoop(const ViewOptions& options);
    ~WindowLoop();
    WindowLoop(const WindowLoop&) = delete;
    WindowLoop& operator=(const WindowLoop&) = delete;

    /// Shows a note while there is no content yet.
    void announce(const char* note);
    /// Shows `content` until the user closes the window.
    void run(WindowContent& content);

    /// Has run() look for something new; from any thread.
    static void wake();

  private:
    using Clock = std::chrono::steady_clock;

    // What GLFW told since the last frame.
    struct Events {
        bool any = true;  // the first frame needs no event
        std::vector<KeyPress> keys;
    };
    static Events& eventsOf(GLFWwindow* window);
    template <typename... Arguments>
    static void noteEvent(GLFWwindow* window, Arguments... arguments);
    static void noteKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);
    void watchEvents();

    bool isEventful();
    bool waitForWork(const WindowContent& content) const;
    void showFrame(WindowContent& content);
    void handleKeys(WindowContent& content);
    void handleKey(WindowContent& content, const KeyPress& press);
    void moveCamera(WindowContent& content, float height) const;
    void showPanel(WindowContent& content, float height);
    void showPicture(WindowContent& content, const PictureArea& area, int windowWidth,
                     int windowHeight);
    void measure(WindowContent& content);
    void savePicture(WindowContent& content);

    std::unique_ptr<gl::Context> context_;
    GLFWwindow* window_;
    Events events_;
    std::unique_ptr<ImGuiSession> imgui_;
    OrbitCamera firstCamera_;
    bool panelIsShown_ = true;
    bool helpIsShown_ = false;
    bool measurementIsDue_ = true;
    Clock::time_point lastMeasured_;
    int framesToSettle_;
    std::string message_;
};

/// The first of `folder`/view-001.png, view-002.png, … that does not exist.
std::filesystem::path nextPictureName(const std::filesystem::path& folder);

}  // namespace relievo::viewer
