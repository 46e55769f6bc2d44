#include "gl/egl_context.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::gl {
namespace {

/// A display to try, and what to call it in messages.
struct Platform {
    EGLDisplay display;
    std::string name;
};

/// Whether the blank-separated list of EGL holds `extension`.
bool hasExtension(EGLDisplay display, std::string_view extension) {
    const char* text = eglQueryString(display, EGL_EXTENSIONS);
    const std::string list = fmt::format(" {} ", text == nullptr ? "" : text);
    return list.find(fmt::format(" {} ", extension)) != std::string::npos;
}

std::vector<Platform> devicePlatforms() {
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    if (queryDevices == nullptr || queryDevices(0, nullptr, &count) != EGL_TRUE)
        return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (queryDevices(count, devices.data(), &count) != EGL_TRUE)
        return {};
    std::vector<Platform> platforms;
    for (EGLint i = 0; i < count; ++i)
        platforms.push_back({eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
                             fmt::format("EGL_EXT_platform_device, device {}", i)});
    return platforms;
}

/// The platforms that need no window system, the preferred one first.
std::vector<Platform> windowlessPlatforms() {
    std::vector<Platform> platforms;
    if (hasExtension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        platforms.push_back(
            {eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
             "EGL_MESA_platform_surfaceless"});
    if (hasExtension(EGL_NO_DISPLAY, "EGL_EXT_platform_device"))
        for (Platform& device : devicePlatforms())
            platforms.push_back(std::move(device));
    return platforms;
}

/// A 4.5 core context on an initialised display. Throws GlError that says what is missing.
EGLContext makeContext(EGLDisplay display, bool debug) {
    if (!hasExtension(display, "EGL_KHR_surfaceless_context"))
        throw GlError("no EGL_KHR_surfaceless_context");
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE)
        throw GlError("no OpenGL");
    constexpr std::array kConfig = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                    EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, kConfig.data(), &config, 1, &count) != EGL_TRUE || count == 0)
        throw GlError("no configuration for OpenGL");
    const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                              4,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              5,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_CONTEXT_OPENGL_DEBUG,
                                              debug ? EGL_TRUE : EGL_FALSE,
                                              EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
    if (context == EGL_NO_CONTEXT)
        throw GlError(fmt::format("no 4.5 core context (EGL error {:#x})", eglGetError()));
    return context;
}

}  // namespace

EglContext::EglContext(const ContextOptions& options) : Context(options.debug) {
    std::string tried;
    for (const Platform& platform : windowlessPlatforms()) {
        // A display is one for the whole process, and terminating it would take the contexts of
        // others with it: it stays initialised until the process ends.
        try {
            if (platform.display == EGL_NO_DISPLAY ||
                eglInitialize(platform.display, nullptr, nullptr) != EGL_TRUE)
                throw GlError(fmt::format("does not start (EGL error {:#x})", eglGetError()));
            context_ = makeContext(platform.display, options.debug);
            display_ = platform.display;
            break;
        } catch (const GlError& error) {
            tried +=
                fmt::format("{}{}: {}", tried.empty() ? "" : "; ", platform.name, error.what());
        }
    }
    if (context_ == nullptr)
        throw GlError(tried.empty() ? "EGL has neither EGL_MESA_platform_surfaceless nor devices "
                                      "(EGL_EXT_platform_device)"
                                    : tried);
    try {
        start();
    } catch (...) {
        eglDestroyContext(display_, context_);
        throw;
    }
}

EglContext::~EglContext() {
    stop();
    eglDestroyContext(display_, context_);
}

void EglContext::attach() {
    // The bound interface is a state of the thread, and another library may have changed it.
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE ||
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
        throw GlError(
            fmt::format("EGL cannot make its context current (EGL error {:#x})", eglGetError()));
}

void EglContext::detach() noexcept {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

Context::FunctionLookup EglContext::functionLookup() const noexcept {
    return eglGetProcAddress;
}

}  // namespace relievo::gl
