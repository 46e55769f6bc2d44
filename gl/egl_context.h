#pragma once

#include "gl/context.h"

namespace relievo::gl {

/// A context of EGL without any surface: on the platform of Mesa that has none, or else on one of
/// the devices that EGL lists.
class EglContext final : public Context {
  public:
    /// Made and current. Throws GlError that says which platforms were tried and what each lacks.
    explicit EglContext(const ContextOptions& options);
    ~EglContext() override;

    [[nodiscard]] Backend backend() const noexcept override { return Backend::Egl; }

  private:
    void attach() override;
    void detach() noexcept override;
    [[nodiscard]] FunctionLookup functionLookup() const noexcept override;

    // EGLDisplay and EGLContext, whose header drags in that of the window system.
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace relievo::gl
