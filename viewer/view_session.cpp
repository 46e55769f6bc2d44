#include "viewer/view_session.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <span>
#include <vector>

#include "textures/map_file.h"
#include "viewer/carrier_mesh.h"
#include "viewer/texture_files.h"

namespace relievo::viewer {
namespace {

// Enough for shares of the light that are a few hundredths off at most.
constexpr int kLightRays = 64;

bool has(std::span<const materials::TechniqueParameter> parameters, std::string_view name) {
    return std::ranges::any_of(parameters, [&](const auto& info) { return info.name == name; });
}

}  // namespace

std::unique_ptr<SceneRenderer> openRelief(const std::filesystem::path& file,
                                          const ViewOptions& options) {
    std::vector<textures::MapSet> levels = textures::readMapLevels(file);
    materials::TextureSet textures =
        readTextureSet(options.textures, options.bakedOcclusion, levels.front(), file.string());
    auto renderer =
        std::make_unique<SceneRenderer>(std::move(levels), file.string(), std::move(textures));
    renderer->setSurface(makeCarrier(options, static_cast<float>(renderer->depthMap().aspect())));
    return renderer;
}

View makeView(const ViewOptions& options, float frameAspect) {
    View view;
    view.camera = perspectiveCamera(options.camera, frameAspect);
    view.toLight = directionTowards(options.light.x, options.light.y);
    view.depthScale = options.depthScale;
    view.window = carrierWindow(options);
    view.slopes = options.normals;
    view.shading = options.shading;
    view.markExhausted = options.markExhausted;
    view.lightRadius = glm::radians(options.lightSize / 2.0f);
    view.lightRays = options.shadow == kNoShadow ? 0 : kLightRays;
    return view;
}

materials::ReliefMaterial makeConfiguredMaterial(const SceneRenderer& renderer,
                                                 const materials::Technique& technique,
                                                 const ViewOptions& options) {
    materials::ReliefMaterial material = renderer.makeMaterial(technique);
    std::span<const materials::TechniqueParameter> shadowParameters;
    if (options.shadow != kNoShadow) {
        material.setShadow(&materials::findShadowMethod(options.shadow));
        shadowParameters = material.shadow()->parameters;
    }
    if (options.level)
        material.levels = glm::vec2(static_cast<float>(*options.level));
    material.pixelRays = options.rays;
    for (const ParameterSetting& setting : options.parameters) {
        if (!setting.technique.empty() && setting.technique != technique.name)
            continue;
        if (has(technique.parameters, setting.name) || has(shadowParameters, setting.name))
            material.setParameter(setting.name, setting.value);
    }
    return material;
}

}  // namespace relievo::viewer
