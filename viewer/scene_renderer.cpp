#include "viewer/scene_renderer.h"

#include <utility>

#include "gl/texture.h"

namespace relievo::viewer {

SceneRenderer::SceneRenderer(textures::MapSet maps, const std::string& name,
                             materials::TextureSet textures)
    : SceneRenderer(std::vector<textures::MapSet>{std::move(maps)}, name, std::move(textures)) {}

SceneRenderer::SceneRenderer(std::vector<textures::MapSet> levels, const std::string& name,
                             materials::TextureSet textures)
    : depthMap_(textures::depthMapOf(levels.front())),
      reliefMaps_(std::make_shared<materials::ReliefMaps>(std::move(levels), name)),
      textures_(std::move(textures), depthMap_.wrap) {}

void SceneRenderer::setSurface(const surfaces::SurfaceMesh& mesh) {
    surface_.emplace(mesh);
}

materials::ReliefMaterial SceneRenderer::makeMaterial(const materials::Technique& technique) const {
    return materials::ReliefMaterial(reliefMaps_, technique);
}

SceneObject SceneRenderer::objectIn(const View& view, materials::ReliefMaterial& material) {
    material.depthScale = view.depthScale;
    material.window = view.window;
    if (view.slopes)
        material.setSlopeSource(*view.slopes);
    SceneObject object;
    object.surface = &surface_.value();
    object.material = &material;
    object.textures = &textures_;
    object.shading = view.shading;
    return object;
}

void SceneRenderer::draw(materials::ReliefMaterial& material, const View& view,
                         gl::Framebuffer& target) {
    const SceneObject object = objectIn(view, material);
    frames_.draw({&object, 1}, view, target);
}

void SceneRenderer::drawReference(const ReferenceFrame& reference, const View& view,
                                  gl::Framebuffer& target) {
    gl::Texture hits(reference.width, reference.height, GL_RGBA32F);
    hits.upload(givenHitTexels(reference), 4);
    hits.setSampling(GL_CLAMP_TO_EDGE, GL_NEAREST);
    materials::ReliefMaterial material = makeMaterial(materials::givenHitsTechnique());
    material.pixelRays = 1;  // all would be given the same hit
    SceneObject object = objectIn(view, material);
    object.givenHits = &hits;
    gl::Texture visibility;
    if (reference.lightRays > 0) {
        visibility = gl::Texture(reference.width, reference.height, GL_R32F);
        visibility.upload(givenVisibilityTexels(reference), 1);
        visibility.setSampling(GL_CLAMP_TO_EDGE, GL_NEAREST);
        material.setShadow(&materials::givenShadowMethod());
        object.givenVisibility = &visibility;
    }
    frames_.draw({&object, 1}, view, target);
}

MeasuredFrame SceneRenderer::measure(materials::ReliefMaterial& material, const View& view,
                                     int width, int height) {
    return frames_.measure(objectIn(view, material), view, width, height);
}

MeasuredFrame SceneRenderer::rays(const View& view, int width, int height) {
    // Normal mapping does no search: it is the cheapest way to get the rays.
    materials::ReliefMaterial material = makeMaterial(materials::findTechnique("normal"));
    View anySlopes = view;
    anySlopes.slopes.reset();
    return measure(material, anySlopes, width, height);
}

ReferenceFrame SceneRenderer::trace(const View& view, int width, int height) {
    return traceReference(rays(view, width, height), depthMap_, view.window, view.depthScale,
                          view.lightRays);
}

}  // namespace relievo::viewer
