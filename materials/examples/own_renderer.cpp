// A renderer with shaders and programs of its own that shows a relief through Relievo: it includes
// the GLSL library in its fragment shader and lets one ReliefMaterial bind maps and parameters.
//
//   own_renderer MAP.exr OUT.png [TECHNIQUE]
#include <glad/gl.h>

#include <array>
#include <exception>
#include <glm/vec3.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "gl/buffer.h"
#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "materials/relief_material.h"
#include "shaders/shader_library.h"
#include "textures/map_file.h"
#include "textures/picture_file.h"

namespace {

using namespace relievo;

// One tile that fills the frame, seen along a slanted direction.
constexpr const char* kVertexShader = R"glsl(
out vec2 uv;
void main() {
    uv = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y, 0.0, 1.0);
})glsl";

// What follows the include of a technique: this renderer's own surface, light and tone.
constexpr const char* kFragmentShader = R"glsl(
#include "relievo/material.glsl"
in vec2 uv;
uniform vec3 view;
out vec4 color;
void main() {
    ReliefSurface surface = ReliefSurface(vec3(uv.x, -uv.y, 0.0), vec3(0.0, 0.0, 1.0),
                                          vec3(1.0, 0.0, 0.0), vec3(0.0, -reliefAspect(), 0.0), uv);
    ReliefFragment relief = traceRelief(surface, view);
    if (relief.hit.outcome != RELIEVO_OUTCOME_HIT) discard;
    float light = max(dot(relief.normal, -view), 0.0);  // the light is where the eye is
    color = vec4(vec3(0.1 + 0.9 * light) * (1.0 - 0.5 * relief.hit.position.z), 1.0);
})glsl";

gl::ShaderText shaderText(GLenum stage, const std::string& text,
                          const std::vector<shaders::Define>& defines) {
    auto shader = shaders::expandShader("own_renderer", text, "#version 450 core", defines);
    return {stage, std::move(shader.text), std::move(shader.files)};
}

void render(const std::string& mapFile, const std::string& picture, const std::string& technique) {
    const auto context = gl::createContext(gl::Backend::OSMesa);
    auto maps = std::make_shared<materials::ReliefMaps>(textures::readMapFile(mapFile), mapFile);
    materials::ReliefMaterial material(std::move(maps), materials::findTechnique(technique));
    material.depthScale = 0.15f;

    const std::string include = "#include \"" + std::string(material.technique().file) + "\"\n";
    gl::Program program(
        {shaderText(GL_VERTEX_SHADER, kVertexShader, {}),
         shaderText(GL_FRAGMENT_SHADER, include + kFragmentShader, material.defines())});
    program.set("view", glm::vec3(0.5f, 0.5f, -0.70710678f));
    material.bind(program.id());

    gl::Framebuffer frame(512, 512, std::array<GLenum, 1>{GL_RGBA8});
    frame.bind();
    frame.clearColor(0, 0, 0, 0, 1);
    const gl::VertexArray none;
    none.bind();
    program.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);

    const std::vector<float> rgba = frame.read(0);
    std::array<textures::Plane, 3> planes;
    for (std::size_t c = 0; c < 3; ++c) {
        planes[c] = textures::Plane(512, 512);
        for (std::size_t k = 0; k < planes[c].texels.size(); ++k)
            planes[c].texels[k] = rgba[4 * k + c];
    }
    textures::writePicture(picture, planes, textures::StorageFormat::U8);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3)
        throw std::runtime_error("usage: own_renderer MAP.exr OUT.png [TECHNIQUE]");
    render(argv[1], argv[2], argc > 3 ? argv[3] : "cone");
} catch (const std::exception& error) {
    std::cerr << "own_renderer: " << error.what() << '\n';
    return 1;
}
