// Relievo from outside: one frame of a flat relief, drawn without a display and seen from above.
// Every pixel must show its hit, lit from the front.
#include <relievo/gl/buffer.h>
#include <relievo/gl/context.h>
#include <relievo/gl/framebuffer.h>
#include <relievo/materials/program_cache.h>
#include <relievo/materials/relief_material.h>
#include <relievo/shaders/relievo/constants.h>
#include <relievo/surfaces/surface_mesh.h>

#include <algorithm>
#include <cstddef>

using namespace relievo;
using surfaces::SurfaceVertex;

int main() {
    const auto context = gl::createContext(gl::Backend::OSMesa, {.debug = true});

    textures::MapSet maps;
    for (const char* channel : {"depth", "dx", "dy"})
        maps.channels.push_back({channel, textures::Plane(4, 4, 0.0f)});
    std::ranges::fill(maps.channels[0].plane.texels, 0.25f);
    const materials::ReliefMaterial material(
        std::make_shared<materials::ReliefMaps>(std::move(maps), "flat"),
        materials::findTechnique("relief"));

    const surfaces::SurfaceMesh mesh = surfaces::makeQuad({1.0f, 1.0f}, 1.0f);
    const gl::Buffer vertices(std::as_bytes(std::span(mesh.vertices)));
    const gl::Buffer indices(std::as_bytes(std::span(mesh.indices)));
    gl::VertexArray surface;
    const auto attribute = [&](GLuint location, int components, std::size_t offset) {
        surface.attribute(location, vertices, components, sizeof(SurfaceVertex), offset);
    };
    attribute(RELIEVO_ATTRIBUTE_POSITION, 3, offsetof(SurfaceVertex, position));
    attribute(RELIEVO_ATTRIBUTE_NORMAL, 3, offsetof(SurfaceVertex, normal));
    attribute(RELIEVO_ATTRIBUTE_TANGENT, 3, offsetof(SurfaceVertex, tangent));
    attribute(RELIEVO_ATTRIBUTE_BITANGENT, 3, offsetof(SurfaceVertex, bitangent));
    attribute(RELIEVO_ATTRIBUTE_UV, 2, offsetof(SurfaceVertex, uv));
    surface.indices(indices);

    const GLenum format = GL_RGBA8;
    gl::Framebuffer frame(8, 8, std::span(&format, 1));
    frame.bind();
    frame.clearColor(0, 0.0f, 0.0f, 0.0f, 1.0f);
    frame.clearDepth();

    materials::ProgramCache programs;
    gl::Program& program =
        programs.get("relievo/programs/shaded.frag", material.technique().file, material.defines());
    material.bind(program.id());
    const glm::mat4 fillFrame(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
    program.set("viewProjection", fillFrame);
    program.set("eye", glm::vec4(0, 0, 1, 0));
    program.set("toLight", glm::vec3(0, 0, 1));
    program.use();
    surface.bind();
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT,
                   nullptr);

    const std::vector<float> pixels = frame.read(0);
    return std::ranges::all_of(pixels, [](float value) { return value > 0.5f; }) ? 0 : 1;
}
