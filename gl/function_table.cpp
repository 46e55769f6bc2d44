#include "gl/function_table.h"

#include <fmt/format.h>

#include <exception>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "gl/context.h"

namespace relievo::gl {
namespace {

/// The driver calls back in the middle of its own C code, through which an exception must not pass.
/// So its message waits here until the call has returned. One a thread, because GL_DEBUG_OUTPUT_
/// SYNCHRONOUS makes the driver call back on the thread of the failing call.
thread_local std::string pendingMessage;

void GLAD_API_PTR recordMessage(GLenum source, GLenum type, GLuint /*id*/, GLenum severity,
                                GLsizei length, const GLchar* text,
                                const void* /*userParam*/) noexcept {
    const bool severe = severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM;
    // What the compiler says is also in the log of the shader, from where Program tells it better.
    if (type != GL_DEBUG_TYPE_ERROR || !severe || source == GL_DEBUG_SOURCE_SHADER_COMPILER)
        return;
    if (!pendingMessage.empty())
        pendingMessage += "; ";
    if (length < 0)
        pendingMessage += text;
    else
        pendingMessage.append(text, static_cast<std::size_t>(length));
}

void beforeCall(const char* /*name*/, GLADapiproc /*function*/, int /*argumentCount*/, ...) {}

/// Throws through glad's wrapper only, which is compiled for it and has nothing to clean up.
void afterCall(void* /*result*/, const char* name, GLADapiproc /*function*/, int /*argumentCount*/,
               ...) {
    if (pendingMessage.empty())
        return;
    // Destructors call these; the message waits for the next call that may throw.
    if (std::uncaught_exceptions() > 0 || std::string_view(name).starts_with("glDelete"))
        return;
    throw GlError(fmt::format("{}: {}", name, std::exchange(pendingMessage, {})));
}

}  // namespace

void pointFunctionsAt(GLADloadfunc lookup, bool debug) {
    static std::mutex mutex;
    static GLADloadfunc loadedFrom = nullptr;
    static bool loadedForDebug = false;

    const std::lock_guard lock(mutex);
    if (loadedFrom == lookup && loadedForDebug == debug)
        return;
    loadedFrom = nullptr;
    const int version = gladLoadGL(lookup);
    if (version < GLAD_MAKE_VERSION(4, 5))
        throw GlError(fmt::format("OpenGL 4.5 is needed, and the driver offers {}.{}",
                                  GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version)));
    if (debug) {
        gladSetGLPreCallback(beforeCall);
        gladSetGLPostCallback(afterCall);
        gladInstallGLDebug();
    } else {
        gladUninstallGLDebug();
    }
    loadedFrom = lookup;
    loadedForDebug = debug;
}

void watchDriverMessages() {
    pendingMessage.clear();
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(recordMessage, nullptr);
}

}  // namespace relievo::gl
