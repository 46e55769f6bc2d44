#include "gl/glfw_context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace relievo::gl {
namespace {

/// glfwTerminate closes every window of the process, so only the last context may call it.
int openWindows = 0;

void throwGlfwError(const char* what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw GlError(fmt::format("{}: {}", what, reason == nullptr ? "GLFW gives no reason" : reason));
}

void releaseGlfw() noexcept {
    if (openWindows == 0)
        glfwTerminate();
}

GLFWwindow* openWindow(const ContextOptions& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    return glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
}

}  // namespace

GlfwContext::GlfwContext(const ContextOptions& options) : Context(options.debug) {
    if (glfwInit() != GLFW_TRUE)
        throwGlfwError("GLFW does not start");
    try {
        window_ = openWindow(options);
        if (window_ == nullptr)
            throwGlfwError("GLFW opens no window for OpenGL 4.5 core");
        start();
    } catch (...) {
        if (window_ != nullptr)
            glfwDestroyWindow(window_);
        releaseGlfw();
        throw;
    }
    ++openWindows;
}

GlfwContext::~GlfwContext() {
    stop();
    glfwDestroyWindow(window_);
    --openWindows;
    releaseGlfw();
}

void GlfwContext::attach() {
    glfwMakeContextCurrent(window_);
    if (glfwGetCurrentContext() != window_)
        throwGlfwError("GLFW cannot make its context current");
}

void GlfwContext::detach() noexcept {
    glfwMakeContextCurrent(nullptr);
}

Context::FunctionLookup GlfwContext::functionLookup() const noexcept {
    return glfwGetProcAddress;
}

}  // namespace relievo::gl
