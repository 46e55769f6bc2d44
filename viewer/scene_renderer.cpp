#include "viewer/scene_renderer.h"

#include <bit>
#include <cmath>

namespace relievo::viewer {
namespace {

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

}  // namespace

SceneRenderer::SceneRenderer(textures::MapSet maps, const std::string& name, const Picture& albedo)
    : SceneRenderer(std::vector<textures::MapSet>{std::move(maps)}, name, albedo) {}

SceneRenderer::SceneRenderer(std::vector<textures::MapSet> levels, const std::string& name,
                             const Picture& albedo)
    : depthMap_(textures::depthMapOf(levels.front())),
      reliefMaps_(std::make_shared<materials::ReliefMaps>(std::move(levels), name)) {
    if (albedo.width > 0) {
        albedo_ = makeAlbedo(albedo, depthMap_.wrap);
        hasAlbedo_ = true;
    }
}

void SceneRenderer::setSurface(const surfaces::SurfaceMesh& mesh) {
    surface_.emplace(mesh);
}

materials::ReliefMaterial SceneRenderer::makeMaterial(const materials::Technique& technique) const {
    return materials::ReliefMaterial(reliefMaps_, technique);
}

SceneObject SceneRenderer::objectIn(const View& view, materials::ReliefMaterial& material) const {
    material.depthScale = view.depthScale;
    material.window = view.window;
    if (view.slopes)
        material.setSlopeSource(*view.slopes);
    SceneObject object;
    object.surface = &surface_.value();
    object.material = &material;
    object.albedo = hasAlbedo_ ? &albedo_ : nullptr;
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
