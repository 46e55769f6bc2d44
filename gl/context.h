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
///
/// Contexts of one back end may be current on several threads at a time; contexts of different back
/// ends, or with and without `debug`, must be used in turn, because the pointers to OpenGL's
/// functions are those of the process. Destroy a context on the thread on which it is current,
/// after the objects made in it.
class Context {
  public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes the context current on this thread, in place of any other of any back end. Throws
    /// GlError when the back end refuses.
    void makeCurrent();
    [[nodiscard]] virtual Backend backend() const noexcept = 0;
    /// GL_RENDERER and GL_VERSION, for reports. The context must be current.
    [[nodiscard]] std::string description() const;

  protected:
    /// Finds a function of OpenGL by its name.
    using FunctionLookup = void (*(*)(const char*))();

    explicit Context(bool debug) noexcept : debug_(debug) {}
    /// Makes a newly made context current and sets up its debug output: the end of each back end's
    /// constructor.
    void start();
    /// Lets go of the context if it is current: the start of each back end's destructor.
    void stop() noexcept;

  private:
    virtual void attach() = 0;
    virtual void detach() noexcept = 0;
    [[nodiscard]] virtual FunctionLookup functionLookup() const noexcept = 0;

    bool debug_;
};

/// Makes a context and makes it current. Throws GlError that says which back end failed and why
/// (for instance: no display for a window).
std::unique_ptr<Context> createContext(Backend backend, const ContextOptions& options = {});

}  // namespace relievo::gl
