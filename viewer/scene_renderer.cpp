#include "viewer/scene_renderer.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <span>

#include "shaders/relievo/constants.h"

namespace relievo::viewer {
namespace {

constexpr std::string_view kShaded = "relievo/programs/shaded.frag";
constexpr std::string_view kMeasured = "relievo/programs/measured.frag";

// An sRGB texture with a mip chain: colours of distant surfaces must be averages, in linear light.
gl::Texture makeAlbedo(const Picture& picture, textures::WrapMode wrap) {
    const int longest = std::max(picture.width, picture.height);
    const int levels = static_cast<int>(std::bit_width(static_cast<unsigned>(longest)));
    gl::Texture texture(picture.width, picture.height, GL_SRGB8_ALPHA8, 0, levels);
    texture.upload(picture.rgba, 4);
    texture.setSampling(materials::glWrapMode(wrap), GL_LINEAR);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateTextureMipmap(texture.id());
    return texture;
}

void prepare(gl::Framebuffer& target) {
    target.bind();
    target.clearDepth();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

}  // namespace

SceneRenderer::SceneRenderer(textures::MapSet maps, const std::string& name, const Picture& albedo)
    : depthMap_(textures::depthMapOf(maps)),
      reliefMaps_(std::make_shared<materials::ReliefMaps>(std::move(maps), name)) {
    if (albedo.width > 0) {
        albedo_ = makeAlbedo(albedo, depthMap_.wrap);
        hasAlbedo_ = true;
    }
}

void SceneRenderer::setSurface(const surfaces::SurfaceMesh& mesh) {
    using surfaces::SurfaceVertex;
    vertices_ = gl::Buffer(std::as_bytes(std::span(mesh.vertices)));
    indices_ = gl::Buffer(std::as_bytes(std::span(mesh.indices)));
    indexCount_ = static_cast<GLsizei>(mesh.indices.size());
    vertexArray_ = gl::VertexArray();
    const auto attribute = [&](GLuint location, int components, std::size_t offset) {
        vertexArray_.attribute(location, vertices_, components, sizeof(SurfaceVertex), offset);
    };
    attribute(RELIEVO_ATTRIBUTE_POSITION, 3, offsetof(SurfaceVertex, position));
    attribute(RELIEVO_ATTRIBUTE_NORMAL, 3, offsetof(SurfaceVertex, normal));
    attribute(RELIEVO_ATTRIBUTE_TANGENT, 3, offsetof(SurfaceVertex, tangent));
    attribute(RELIEVO_ATTRIBUTE_BITANGENT, 3, offsetof(SurfaceVertex, bitangent));
    attribute(RELIEVO_ATTRIBUTE_UV, 2, offsetof(SurfaceVertex, uv));
    vertexArray_.indices(indices_);
}

materials::ReliefMaterial SceneRenderer::makeMaterial(const materials::Technique& technique) const {
    return materials::ReliefMaterial(reliefMaps_, technique);
}

void SceneRenderer::drawSurface(gl::Program& program, materials::ReliefMaterial& material,
                                const View& view, const gl::Texture* givenHits) {
    material.depthScale = view.depthScale;
    material.window = view.window;
    GLuint unit = material.bind(program.id());
    if (givenHits) {
        program.set("relievoGivenHits", static_cast<int>(unit));
        givenHits->bind(unit++);
    }
    if (program.hasUniform("albedoMap")) {
        program.set("albedoMap", static_cast<int>(unit));
        albedo_.bind(unit++);
    }
    program.set("viewProjection", view.camera.viewProjection);
    program.set("eye", view.camera.eye);
    program.use();
    vertexArray_.bind();
    glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

void SceneRenderer::drawShaded(materials::ReliefMaterial& material, const View& view,
                               gl::Framebuffer& target, const gl::Texture* givenHits) {
    std::vector<shaders::Define> defines = material.defines();
    if (hasAlbedo_)
        defines.push_back({"RELIEVO_ALBEDO", "1"});
    if (view.markExhausted)
        defines.push_back({"RELIEVO_MARK_EXHAUSTED", "1"});
    gl::Program& program = programs_.get(kShaded, material.technique().file, defines);
    prepare(target);
    target.clearColor(0, 0.09f, 0.09f, 0.1f, 1.0f);
    program.set("toLight", view.toLight);
    drawSurface(program, material, view, givenHits);
}

void SceneRenderer::draw(materials::ReliefMaterial& material, const View& view,
                         gl::Framebuffer& target) {
    drawShaded(material, view, target, nullptr);
}

void SceneRenderer::drawReference(const ReferenceFrame& reference, const View& view,
                                  gl::Framebuffer& target) {
    gl::Texture hits(reference.width, reference.height, GL_RGBA32F);
    hits.upload(givenHitTexels(reference), 4);
    hits.setSampling(GL_CLAMP_TO_EDGE, GL_NEAREST);
    materials::ReliefMaterial material = makeMaterial(materials::givenHitsTechnique());
    drawShaded(material, view, target, &hits);
}

MeasuredFrame SceneRenderer::measure(materials::ReliefMaterial& material, const View& view,
                                     int width, int height) {
    gl::Framebuffer target = makeMeasuredTarget(width, height);
    gl::Program& program = programs_.get(kMeasured, material.technique().file, material.defines());
    prepare(target);
    for (int attachment = 0; attachment < RELIEVO_OUTPUT_COUNT; ++attachment)
        target.clearColor(attachment, 0, 0, 0, 0);
    drawSurface(program, material, view, nullptr);
    return readMeasuredFrame(target);
}

MeasuredFrame SceneRenderer::rays(const View& view, int width, int height) {
    // Normal mapping does no search: it is the cheapest way to get the rays.
    materials::ReliefMaterial material = makeMaterial(materials::findTechnique("normal"));
    return measure(material, view, width, height);
}

ReferenceFrame SceneRenderer::trace(const View& view, int width, int height) {
    return traceReference(rays(view, width, height), depthMap_, view.window, view.depthScale);
}

}  // namespace relievo::viewer
