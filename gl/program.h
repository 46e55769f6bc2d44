#pragma once

#include <glad/gl.h>

#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gl/object_name.h"

namespace relievo::gl {

void deleteProgram(GLuint id) noexcept;

/// The text of one shader stage. `#line N K` directives in it refer to files[K], so that the
/// driver's messages can be told in terms of the source files.
struct ShaderText {
    GLenum stage = 0;  ///< GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, …
    std::string text;
    std::vector<std::string> files;
};

/// An owning linked program. Uniforms are set by name without making the program current. Setting a
/// uniform that the program does not have is an error: it is either misspelt or not needed, and
/// both are worth knowing. Move only. Its context must be current whenever it is used, and when it
/// is destroyed.
class Program {
  public:
    Program() = default;
    /// Compiles and links. Throws GlError with the driver's messages, each as `file:line: text`.
    explicit Program(const std::vector<ShaderText>& stages);

    void use() const;
    [[nodiscard]] GLuint id() const noexcept { return name_.id(); }
    [[nodiscard]] bool hasUniform(std::string_view name) const;

    /// Sets a uniform, or one element `name[i]` of an array. Samplers and images are set to the
    /// number of their unit. Throws GlError when there is none of that name (it lists those there
    /// are) or when it is of another type.
    void set(std::string_view name, int value);
    void set(std::string_view name, float value);
    void set(std::string_view name, const glm::ivec2& value);
    void set(std::string_view name, const glm::vec2& value);
    void set(std::string_view name, const glm::vec3& value);
    void set(std::string_view name, const glm::vec4& value);
    void set(std::string_view name, const glm::mat3& value);
    void set(std::string_view name, const glm::mat4& value);

  private:
    struct Uniform {
        GLint location;
        GLenum type;
    };

    void listUniforms();
    /// Where to set the uniform `name` of type `type`.
    [[nodiscard]] GLint location(std::string_view name, GLenum type) const;

    ObjectName<deleteProgram> name_;
    std::map<std::string, Uniform, std::less<>> uniforms_;
};

}  // namespace relievo::gl
