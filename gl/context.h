#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace relievo::gl {

/// What went wrong inside OpenGL or while making a context: a message of the driver, a missing
/// uniform, an incomplete framebuffer, a shader that does not compile.
class GlError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The ways to an OpenGL 4.5 core context: OSMesa (software, no display), EGL surfaceless (no
/// display), a GLFW window.
enum class Backend { OSMesa, Egl, Glfw };

/// "osmesa", "egl", "glfw".
std::string_view backendName(Backend backend) noexcept;
std::optional<Backend> backendFromName(std::string_view name) noexcept;

struct ContextOptions {
    int width = 64;  ///< of the window; the windowless back ends draw to framebuffer objects only
    int height = 64;
    std::string title = "Relievo";
    bool debug = false;   ///< turn the driver's errors into GlError, thrown at the failing call
    bool visible = true;  ///< of the window
};

/// An OpenGL 4.5 core context. It is current on the thread that made it until another is made
/// current. All drawing goes to framebuffer objects, so that the three back ends run the same code.
class Context {
  public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual void makeCurrent() = 0;
    [[nodiscard]] virtual Backend backend() const noexcept = 0;
    /// GL_RENDERER and GL_VERSION, for reports.
    [[nodiscard]] std::string description() const;

  protected:
    Context() = default;
};

/// Makes a context and makes it current. Throws GlError that says which back end failed and why
/// (for instance: no display for a window).
std::unique_ptr<Context> createContext(Backend backend, const ContextOptions& options = {});

}  // namespace relievo::gl
