#pragma once

#include <glad/gl.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace relievo::gl {

/// The text of one shader stage. `#line N K` directives in it refer to files[K], so that the
/// driver's messages can be told in terms of the source files.
struct ShaderText {
    GLenum stage = 0;  ///< GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, …
    std::string text;
    std::vector<std::string> files;
};

/// An owning linked program. Uniforms are set by name without making the program current. Setting a
/// uniform that the program does not have is an error: it is either misspelt or not needed, and
/// both are worth knowing. Move only.
class Program {
  public:
    Program() = default;
    /// Compiles and links. Throws GlError with the driver's messages, each as `file:line: text`.
    explicit Program(const std::vector<ShaderText>& stages);
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;

    void use() const;
    [[nodiscard]] GLuint id() const noexcept { return id_; }
    [[nodiscard]] bool hasUniform(std::string_view name) const;

    void set(std::string_view name, int value);
    void set(std::string_view name, float value);
    void set(std::string_view name, const glm::ivec2& value);
    void set(std::string_view name, const glm::vec2& value);
    void set(std::string_view name, const glm::vec3& value);
    void set(std::string_view name, const glm::vec4& value);
    void set(std::string_view name, const glm::mat3& value);
    void set(std::string_view name, const glm::mat4& value);

  private:
    [[nodiscard]] GLint location(std::string_view name) const;

    GLuint id_ = 0;
    std::unordered_map<std::string, GLint> locations_;
};

}  // namespace relievo::gl
