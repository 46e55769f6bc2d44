#pragma once

#include "gl/context.h"

struct GLFWwindow;

namespace relievo::gl {

/// A context with a window. GLFW wants all of it on the main thread.
class GlfwContext final : public Context {
  public:
    /// Made and current. Throws GlError with the reason of GLFW, such as a missing display.
    explicit GlfwContext(const ContextOptions& options);
    ~GlfwContext() override;

    [[nodiscard]] Backend backend() const noexcept override { return Backend::Glfw; }
    /// For input, the size of the default framebuffer, and swapping buffers.
    [[nodiscard]] GLFWwindow* window() const noexcept { return window_; }

  private:
    void attach() override;
    void detach() noexcept override;
    [[nodiscard]] FunctionLookup functionLookup() const noexcept override;

    GLFWwindow* window_ = nullptr;
};

}  // namespace relievo::gl
