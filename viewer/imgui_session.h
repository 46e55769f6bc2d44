#pragma once

struct GLFWwindow;

namespace relievo::viewer {

/// The size of the panel's letters in pixels; positions in the panel are laid out from it.
inline constexpr float kFontSize = 14.0f;

/// Dear ImGui on a window of GLFW, with Relievo's look. The window's own callbacks must be set
/// before: they are called first. Only one at a time.
class ImGuiSession {
  public:
    /// The context of `window` must be current.
    explicit ImGuiSession(GLFWwindow* window);
    ~ImGuiSession();
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;

    /// Starts a frame: widgets may follow.
    void begin();
    /// Ends the frame and draws its widgets to the current framebuffer.
    void end();
};

}  // namespace relievo::viewer
