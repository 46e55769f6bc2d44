#include "gl/context.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include "gl/egl_context.h"
#include "gl/function_table.h"
#include "gl/glfw_context.h"
#include "gl/osmesa_context.h"

namespace relievo::gl {
namespace {

/// The back ends do not know of each other's current contexts, although they share the dispatch
/// table of Mesa below: each must be let go before another is attached.
thread_local Context* currentContext = nullptr;

std::string glString(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text == nullptr ? "?" : reinterpret_cast<const char*>(text);
}

std::unique_ptr<Context> makeContext(Backend backend, const ContextOptions& options) {
    switch (backend) {
        case Backend::OSMesa:
            return std::make_unique<OSMesaContext>(options);
        case Backend::Egl:
            return std::make_unique<EglContext>(options);
        case Backend::Glfw:
            break;
    }
    return std::make_unique<GlfwContext>(options);
}

}  // namespace

std::string_view backendName(Backend backend) noexcept {
    switch (backend) {
        case Backend::OSMesa:
            return "osmesa";
        case Backend::Egl:
            return "egl";
        case Backend::Glfw:
            break;
    }
    return "glfw";
}

std::optional<Backend> backendFromName(std::string_view name) noexcept {
    for (const Backend backend : {Backend::OSMesa, Backend::Egl, Backend::Glfw})
        if (backendName(backend) == name)
            return backend;
    return std::nullopt;
}

void Context::makeCurrent() {
    if (currentContext != this) {
        if (currentContext != nullptr)
            currentContext->detach();
        currentContext = nullptr;
        attach();
        currentContext = this;
    }
    pointFunctionsAt(functionLookup(), debug_);
}

void Context::start() {
    try {
        makeCurrent();
        if (debug_)
            watchDriverMessages();
    } catch (...) {
        stop();  // the destructor of a back end does not run when its constructor throws
        throw;
    }
}

void Context::stop() noexcept {
    if (currentContext != this)
        return;
    detach();
    currentContext = nullptr;
}

std::string Context::description() const {
    return fmt::format("{}, OpenGL {}", glString(GL_RENDERER), glString(GL_VERSION));
}

std::unique_ptr<Context> createContext(Backend backend, const ContextOptions& options) {
    try {
        return makeContext(backend, options);
    } catch (const GlError& error) {
        throw GlError(
            fmt::format("no OpenGL context through {}: {}", backendName(backend), error.what()));
    }
}

}  // namespace relievo::gl
