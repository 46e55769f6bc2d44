#include "relief_scene.h"

#include <limits>

#include "materials/technique_registry.h"
#include "preprocess/cone_encoding.h"
#include "preprocess/conservative_cones.h"
#include "preprocess/derivatives.h"

namespace relievo::viewer {

textures::MapSet bakeMaps(const textures::DepthMap& map, textures::ConeEncoding encoding) {
    const preprocess::Derivatives derivatives = preprocess::buildDerivatives(map);
    textures::MapSet maps;
    maps.wrap = map.wrap;
    maps.encoding = encoding;
    maps.channels = {{"depth", map.depth},
                     {"dx", derivatives.dx},
                     {"dy", derivatives.dy},
                     {"cone", preprocess::encodeCones(preprocess::buildConservativeCones(
                                                          map, preprocess::ConeGuarantee::Texel),
                                                      map.depth, encoding)}};
    return maps;
}

RayScene::RayScene(const textures::MapSet& maps, float azimuth, float elevation, float depthScale)
    : renderer(maps, "test", Picture()) {
    const auto aspect = static_cast<float>(renderer.depthMap().aspect());
    renderer.setSurface(surfaces::makeQuad({1, 1}, aspect));
    view.camera = parallelRays(azimuth, elevation, aspect);
    view.depthScale = depthScale;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    view.window = {-kInfinity, -kInfinity, kInfinity, kInfinity};
}

reference::ErrorStatistics RayScene::errors(const materials::Technique& technique, int size) {
    materials::ReliefMaterial material = renderer.makeMaterial(technique);
    return errors(material, size);
}

reference::ErrorStatistics RayScene::errors(materials::ReliefMaterial& material, int size) {
    const MeasuredFrame frame = renderer.measure(material, view, size, size);
    const ReferenceFrame exact =
        traceReference(frame, renderer.depthMap(), view.window, view.depthScale);
    return reference::summarizeErrors(
        compareFrames(frame, exact, renderer.depthMap(), view.depthScale),
        1.0 / renderer.depthMap().width());
}

std::unique_ptr<gl::Context> makeTestContext() {
    return gl::createContext(gl::Backend::OSMesa, {.debug = true});
}

gl::Framebuffer makeColorTarget(int width, int height) {
    return gl::Framebuffer(width, height, std::array<GLenum, 1>{GL_RGBA8});
}

}  // namespace relievo::viewer
