#include "gl/osmesa_context.h"

#include <glad/gl.h>
// After glad, whose header replaces GL/gl.h.
#include <GL/osmesa.h>

namespace relievo::gl {

OSMesaContext::OSMesaContext(const ContextOptions& options) : Context(options.debug) {
    constexpr std::array kAttributes = {OSMESA_FORMAT,
                                        OSMESA_RGBA,
                                        OSMESA_PROFILE,
                                        OSMESA_CORE_PROFILE,
                                        OSMESA_CONTEXT_MAJOR_VERSION,
                                        4,
                                        OSMESA_CONTEXT_MINOR_VERSION,
                                        5,
                                        0};
    context_.reset(OSMesaCreateContextAttribs(kAttributes.data(), nullptr));
    if (!context_)
        throw GlError("OSMesa offers no OpenGL 4.5 core context");
    start();
}

OSMesaContext::~OSMesaContext() {
    stop();
}

void OSMesaContext::Destroy::operator()(osmesa_context* context) const noexcept {
    OSMesaDestroyContext(context);
}

void OSMesaContext::attach() {
    if (OSMesaMakeCurrent(context_.get(), defaultFramebuffer_.data(), GL_UNSIGNED_BYTE, 1, 1) !=
        GL_TRUE)
        throw GlError("OSMesa cannot make its context current");
}

void OSMesaContext::detach() noexcept {
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
}

Context::FunctionLookup OSMesaContext::functionLookup() const noexcept {
    return OSMesaGetProcAddress;
}

}  // namespace relievo::gl
