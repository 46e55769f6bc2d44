#include "gl/program.h"

#include <fmt/format.h>

#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "gl/context.h"
#include "gl/shader_log.h"

namespace relievo::gl {
namespace {

void deleteShader(GLuint id) noexcept {
    glDeleteShader(id);
}
using Shader = ObjectName<deleteShader>;

std::string_view stageName(GLenum stage) noexcept {
    switch (stage) {
        case GL_VERTEX_SHADER:
            return "vertex";
        case GL_TESS_CONTROL_SHADER:
            return "tessellation control";
        case GL_TESS_EVALUATION_SHADER:
            return "tessellation evaluation";
        case GL_GEOMETRY_SHADER:
            return "geometry";
        case GL_FRAGMENT_SHADER:
            return "fragment";
        case GL_COMPUTE_SHADER:
            return "compute";
        default:
            return "unknown";
    }
}

/// The GLSL name of a type that `Program::set` takes or that a user might mistake for one; empty
/// for the opaque types (samplers, images), which are many and set alike.
std::string_view typeName(GLenum type) noexcept {
    struct Entry {
        GLenum type;
        std::string_view name;
    };
    static constexpr std::array kNames = {Entry{GL_FLOAT, "float"},
                                          Entry{GL_FLOAT_VEC2, "vec2"},
                                          Entry{GL_FLOAT_VEC3, "vec3"},
                                          Entry{GL_FLOAT_VEC4, "vec4"},
                                          Entry{GL_INT, "int"},
                                          Entry{GL_INT_VEC2, "ivec2"},
                                          Entry{GL_INT_VEC3, "ivec3"},
                                          Entry{GL_INT_VEC4, "ivec4"},
                                          Entry{GL_UNSIGNED_INT, "uint"},
                                          Entry{GL_UNSIGNED_INT_VEC2, "uvec2"},
                                          Entry{GL_UNSIGNED_INT_VEC3, "uvec3"},
                                          Entry{GL_UNSIGNED_INT_VEC4, "uvec4"},
                                          Entry{GL_BOOL, "bool"},
                                          Entry{GL_BOOL_VEC2, "bvec2"},
                                          Entry{GL_BOOL_VEC3, "bvec3"},
                                          Entry{GL_BOOL_VEC4, "bvec4"},
                                          Entry{GL_FLOAT_MAT2, "mat2"},
                                          Entry{GL_FLOAT_MAT3, "mat3"},
                                          Entry{GL_FLOAT_MAT4, "mat4"},
                                          Entry{GL_FLOAT_MAT2x3, "mat2x3"},
                                          Entry{GL_FLOAT_MAT2x4, "mat2x4"},
                                          Entry{GL_FLOAT_MAT3x2, "mat3x2"},
                                          Entry{GL_FLOAT_MAT3x4, "mat3x4"},
                                          Entry{GL_FLOAT_MAT4x2, "mat4x2"},
                                          Entry{GL_FLOAT_MAT4x3, "mat4x3"},
                                          Entry{GL_DOUBLE, "double"}};
    for (const Entry& entry : kNames)
        if (entry.type == type)
            return entry.name;
    return {};
}

/// Whether a value of type `given` may be set on a uniform of type `declared`.
bool accepts(GLenum declared, GLenum given) noexcept {
    if (given == GL_INT)
        return declared == GL_INT || declared == GL_BOOL || typeName(declared).empty();
    return declared == given || (declared == GL_BOOL_VEC2 && given == GL_INT_VEC2);
}

std::string shaderLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

std::string programLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

Shader compile(const ShaderText& source) {
    Shader shader(glCreateShader(source.stage));
    if (shader.id() == 0)
        throw GlError(fmt::format("there is no shader stage {:#06x}", source.stage));
    const TracedText traced = traceLines(source.text);
    const GLchar* text = traced.text.data();
    const auto length = static_cast<GLint>(traced.text.size());
    glShaderSource(shader.id(), 1, &text, &length);
    glCompileShader(shader.id());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE)
        throw GlError(
            fmt::format("the {} shader does not compile:\n{}", stageName(source.stage),
                        locateMessages(shaderLog(shader.id()), traced.lines, source.files)));
    return shader;
}

GLint programValue(GLuint program, GLenum name) {
    GLint value = 0;
    glGetProgramiv(program, name, &value);
    return value;
}

}  // namespace

void deleteProgram(GLuint id) noexcept {
    glDeleteProgram(id);
}

Program::Program(const std::vector<ShaderText>& stages) : name_(glCreateProgram()) {
    std::vector<Shader> shaders;
    for (const ShaderText& stage : stages)
        shaders.push_back(compile(stage));
    for (const Shader& shader : shaders)
        glAttachShader(id(), shader.id());
    glLinkProgram(id());
    if (programValue(id(), GL_LINK_STATUS) == GL_FALSE)
        throw GlError(fmt::format("the shaders do not link:\n{}", programLog(id())));
    for (const Shader& shader : shaders)
        glDetachShader(id(), shader.id());
    listUniforms();
}

void Program::listUniforms() {
    const GLint count = programValue(id(), GL_ACTIVE_UNIFORMS);
    std::string buffer(static_cast<std::size_t>(programValue(id(), GL_ACTIVE_UNIFORM_MAX_LENGTH)),
                       '\0');
    for (GLint i = 0; i < count; ++i) {
        GLsizei length = 0;
        GLint elements = 0;
        GLenum type = 0;
        glGetActiveUniform(id(), static_cast<GLuint>(i), static_cast<GLsizei>(buffer.size()),
                           &length, &elements, &type, buffer.data());
        std::string name = buffer.substr(0, static_cast<std::size_t>(length));
        const GLint location = glGetUniformLocation(id(), name.c_str());
        if (location < 0)
            continue;  // a member of a uniform block
        const bool isArray = name.ends_with("[0]");
        if (isArray)
            name.resize(name.size() - 3);
        uniforms_.emplace(name, Uniform{location, type});
        for (GLint element = 0; isArray && element < elements; ++element) {
            const std::string elementName = fmt::format("{}[{}]", name, element);
            uniforms_.emplace(elementName,
                              Uniform{glGetUniformLocation(id(), elementName.c_str()), type});
        }
    }
}

void Program::use() const {
    glUseProgram(id());
}

bool Program::hasUniform(std::string_view name) const {
    return uniforms_.find(name) != uniforms_.end();
}

GLint Program::location(std::string_view name, GLenum type) const {
    const auto found = uniforms_.find(name);
    if (found == uniforms_.end()) {
        std::string names;
        for (const auto& [present, uniform] : uniforms_)
            names += fmt::format("{}{}", names.empty() ? "" : ", ", present);
        throw GlError(fmt::format("the program has no uniform '{}'; it has {}", name,
                                  names.empty() ? "none" : names));
    }
    const GLenum declared = found->second.type;
    if (!accepts(declared, type))
        throw GlError(fmt::format("the uniform '{}' is a {}, not a {}", name,
                                  typeName(declared).empty() ? "sampler" : typeName(declared),
                                  typeName(type)));
    return found->second.location;
}

void Program::set(std::string_view name, int value) {
    glProgramUniform1i(id(), location(name, GL_INT), value);
}

void Program::set(std::string_view name, float value) {
    glProgramUniform1f(id(), location(name, GL_FLOAT), value);
}

void Program::set(std::string_view name, const glm::ivec2& value) {
    glProgramUniform2iv(id(), location(name, GL_INT_VEC2), 1, glm::value_ptr(value));
}

void Program::set(std::string_view name, const glm::vec2& value) {
    glProgramUniform2fv(id(), location(name, GL_FLOAT_VEC2), 1, glm::value_ptr(value));
}

void Program::set(std::string_view name, const glm::vec3& value) {
    glProgramUniform3fv(id(), location(name, GL_FLOAT_VEC3), 1, glm::value_ptr(value));
}

void Program::set(std::string_view name, const glm::vec4& value) {
    glProgramUniform4fv(id(), location(name, GL_FLOAT_VEC4), 1, glm::value_ptr(value));
}

void Program::set(std::string_view name, const glm::mat3& value) {
    glProgramUniformMatrix3fv(id(), location(name, GL_FLOAT_MAT3), 1, GL_FALSE,
                              glm::value_ptr(value));
}

void Program::set(std::string_view name, const glm::mat4& value) {
    glProgramUniformMatrix4fv(id(), location(name, GL_FLOAT_MAT4), 1, GL_FALSE,
                              glm::value_ptr(value));
}

}  // namespace relievo::gl
