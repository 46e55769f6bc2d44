#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "gl/context.h"

struct osmesa_context;

namespace relievo::gl {

/// A context of Mesa's software renderer that needs no display and no device.
class OSMesaContext final : public Context {
  public:
    /// Made and current. Throws GlError when Mesa offers no 4.5 core context.
    explicit OSMesaContext(const ContextOptions& options);
    ~OSMesaContext() override;

    [[nodiscard]] Backend backend() const noexcept override { return Backend::OSMesa; }

  private:
    struct Destroy {
        void operator()(osmesa_context* context) const noexcept;
    };

    void attach() override;
    void detach() noexcept override;
    [[nodiscard]] FunctionLookup functionLookup() const noexcept override;

    std::unique_ptr<osmesa_context, Destroy> context_;
    /// OSMesa wants a default framebuffer in the caller's memory; we draw to framebuffer objects.
    std::array<std::uint8_t, 4> defaultFramebuffer_{};
};

}  // namespace relievo::gl
