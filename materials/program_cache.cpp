#include "materials/program_cache.h"

#include <fmt/format.h>

namespace relievo::materials {
namespace {

constexpr std::string_view kHeader = "#version 450 core";
constexpr std::string_view kVertexFile = "relievo/programs/surface.vert";

gl::ShaderText toShaderText(GLenum stage, shaders::ExpandedShader shader) {
    return {stage, std::move(shader.text), std::move(shader.files)};
}

}  // namespace

shaders::ExpandedShader expandFragment(std::string_view fragmentFile,
                                       const std::vector<std::string_view>& materialFiles,
                                       std::span<const shaders::Define> defines) {
    std::string text;
    for (const std::string_view file : materialFiles)
        text += fmt::format("#include \"{}\"\n", file);
    text += fmt::format("#include \"{}\"\n", fragmentFile);
    return shaders::expandShader("fragment shader", text, kHeader, defines);
}

gl::Program& ProgramCache::get(std::string_view fragmentFile,
                               const std::vector<std::string_view>& materialFiles,
                               std::span<const shaders::Define> defines) {
    shaders::ExpandedShader fragment = expandFragment(fragmentFile, materialFiles, defines);
    if (const auto found = programs_.find(fragment.text); found != programs_.end())
        return found->second;
    const std::string vertex = fmt::format("#include \"{}\"\n", kVertexFile);
    std::string key = fragment.text;
    gl::Program program(
        {toShaderText(GL_VERTEX_SHADER, shaders::expandShader("vertex shader", vertex, kHeader)),
         toShaderText(GL_FRAGMENT_SHADER, std::move(fragment))});
    return programs_.emplace(std::move(key), std::move(program)).first->second;
}

}  // namespace relievo::materials
