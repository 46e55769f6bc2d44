#include "viewer/view_session.h"

#include <algorithm>

#include "textures/map_file.h"

namespace relievo::viewer {

std::unique_ptr<SceneRenderer> openRelief(const std::filesystem::path& file,
                                          const ViewOptions& options) {
    textures::MapSet maps = textures::readMapFile(file);
    const Picture albedo = options.albedo.empty() ? Picture() : readPicture(options.albedo);
    auto renderer = std::make_unique<SceneRenderer>(std::move(maps), file.string(), albedo);
    renderer->setSurface(makeObject(options, static_cast<float>(renderer->depthMap().aspect())));
    return renderer;
}

surfaces::SurfaceMesh makeObject(const ViewOptions& options, float aspect) {
    return options.object == ObjectKind::Box ? surfaces::makeBox(options.tiles)
                                             : surfaces::makeQuad(options.tiles, aspect);
}

View makeView(const ViewOptions& options, float frameAspect) {
    View view;
    view.camera = perspectiveCamera(options.camera, frameAspect);
    view.toLight = directionTowards(options.light.x, options.light.y);
    // Both objects are one unit wide and hold tiles.x tiles; the scale counts tile widths.
    view.depthScale = options.depthScale;
    view.window = glm::vec4(0.0f, 0.0f, options.tiles.x, options.tiles.y);
    view.slopes = options.normals;
    view.markExhausted = options.markExhausted;
    return view;
}

materials::ReliefMaterial makeConfiguredMaterial(const SceneRenderer& renderer,
                                                 const materials::Technique& technique,
                                                 const ViewOptions& options) {
    materials::ReliefMaterial material = renderer.makeMaterial(technique);
    for (const ParameterSetting& setting : options.parameters) {
        if (!setting.technique.empty() && setting.technique != technique.name)
            continue;
        const bool has = std::ranges::any_of(
            technique.parameters, [&](const auto& info) { return info.name == setting.name; });
        if (has)
            material.setParameter(setting.name, setting.value);
    }
    return material;
}

}  // namespace relievo::viewer
