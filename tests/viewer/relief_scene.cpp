#include "relief_scene.h"

#include <limits>
#include <utility>

#include "bench/technique_maps.h"
#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"

namespace relievo::viewer {

textures::MapSet bakeMaps(const textures::DepthMap& map, textures::ConeEncoding encoding) {
    preprocess::ReliefPlan plan;
    plan.maps.insert(plan.maps.end(), {"extrema", "cylinder", "volume"});
    if (encoding == textures::ConeEncoding::Radius)
        plan.guarantee = "texel";
    plan.encoding = encoding;
    textures::MapSet maps = preprocess::bakeRelief(map, plan);
    preprocess::ReliefPlan roofs;
    roofs.maps = {"cone"};
    roofs.cone = "roof";
    textures::MapSet roofMaps = preprocess::bakeRelief(map, roofs);
    for (textures::Channel& channel : roofMaps.channels)
        if (maps.find(channel.name) == nullptr)
            maps.channels.push_back(std::move(channel));
    return maps;
}

textures::MapSet bakeMapsFor(const materials::Technique& technique, const textures::DepthMap& map,
                             textures::ConeEncoding encoding) {
    const preprocess::ReliefPlan plan = bench::planFor(technique);
    const bool isApart = plan.cone == "relaxed" || plan.has("vdm");
    return isApart ? preprocess::bakeRelief(map, plan) : bakeMaps(map, encoding);
}

RayScene::RayScene(const textures::MapSet& maps, float azimuth, float elevation, float depthScale)
    : renderer(maps, "test", {}) {
    renderer.setSurface(
        surfaces::makeQuad({1, 1}, static_cast<float>(renderer.depthMap().aspect())));
    look(azimuth, elevation, depthScale);
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    view.window = {-kInfinity, -kInfinity, kInfinity, kInfinity};
}

void RayScene::look(float azimuth, float elevation, float depthScale) {
    view.camera =
        parallelRays(azimuth, elevation, static_cast<float>(renderer.depthMap().aspect()));
    view.depthScale = depthScale;
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

std::vector<const materials::Technique*> everyTechnique() {
    std::vector<const materials::Technique*> techniques;
    for (const materials::Technique& technique : materials::techniques())
        techniques.push_back(&technique);
    return techniques;
}

std::vector<const textures::SampleRelief*> everySample() {
    std::vector<const textures::SampleRelief*> samples;
    for (const textures::SampleRelief& sample : textures::sampleReliefs())
        samples.push_back(&sample);
    return samples;
}

std::unique_ptr<gl::Context> makeTestContext() {
    return gl::createContext(gl::Backend::OSMesa, {.debug = true});
}

gl::Framebuffer makeColorTarget(int width, int height) {
    return gl::Framebuffer(width, height, std::array<GLenum, 1>{GL_RGBA8});
}

}  // namespace relievo::viewer
