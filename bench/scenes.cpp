#include "bench/scenes.h"

#include <array>
#include <cassert>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "bench/technique_maps.h"
#include "preprocess/relief_baker.h"
#include "textures/sample_reliefs.h"

namespace relievo::bench {
namespace {

using surfaces::makeBox;
using surfaces::makeQuad;
using surfaces::placed;

glm::mat4 at(glm::vec3 position, float scale) {
    return glm::scale(glm::translate(glm::mat4(1), position), glm::vec3(scale));
}

glm::mat4 turned(const glm::mat4& placement, float degrees, glm::vec3 axis) {
    return glm::rotate(placement, glm::radians(degrees), axis);
}

// A paved floor, seen along it up to a wall of bricks; behind that a box.
SceneModel hiddenScene() {
    constexpr glm::vec3 kX(1, 0, 0);
    SceneModel model;
    model.parts.push_back({placed(makeBox({2, 2}), at({1, 15, 1.8f}, 3.6f)), "hemispheres", 0.1f});
    model.parts.push_back(
        {placed(makeQuad({12, 4}, 1), turned(at({0, 12, 2}, 12), 90, kX)), "bricks", 0.04f});
    model.parts.push_back({placed(makeQuad({16, 16}, 1), at({0, 4, 0}, 16)), "cobbles", 0.1f});
    model.eye = {.azimuth = 0, .elevation = 8, .distance = 3, .target = {0, 0, 0.5f}};
    model.light = {.azimuth = -50, .elevation = 45, .distance = 30, .target = {0, 4, 0}};
    return model;
}

SceneModel intersectionsScene() {
    constexpr glm::vec3 kY(0, 1, 0);
    constexpr glm::vec3 kZ(0, 0, 1);
    SceneModel model;
    model.parts.push_back({placed(makeQuad({2, 2}, 1), at({0, 0, 0}, 2)), "hemispheres", 0.25f});
    model.parts.push_back(
        {placed(makeQuad({2, 2}, 1), turned(at({0.15f, 0, -0.02f}, 1.6f), -22, kY)), "bricks",
         0.2f});
    model.parts.push_back(
        {placed(makeBox({1, 1}), turned(at({-0.45f, -0.25f, 0}, 0.5f), 30, kZ)), "", 0});
    model.eye = {.azimuth = 20, .elevation = 38, .distance = 2.9f, .target = {0, 0, -0.05f}};
    model.light = {.azimuth = -50, .elevation = 40, .distance = 4};
    return model;
}

struct NamedScene {
    std::string_view name;
    SceneModel (*make)();
};
constexpr std::array kScenes = {NamedScene{"hidden", hiddenScene},
                                NamedScene{"intersections", intersectionsScene}};

}  // namespace

std::span<const std::string_view> sceneNames() {
    static constexpr std::array<std::string_view, kScenes.size()> kNames = {kScenes[0].name,
                                                                            kScenes[1].name};
    return kNames;
}

SceneModel sceneModel(std::string_view name) {
    const auto found = std::ranges::find(kScenes, name, &NamedScene::name);
    assert(found != kScenes.end());
    return found->make();
}

StagedScene::StagedScene(const SceneModel& model, const materials::Technique& technique, int size)
    : model_(model), technique_(technique) {
    for (const ScenePart& part : model.parts) {
        surfaces_.emplace_back(part.mesh);
        materials_.emplace_back();
        if (part.sample.empty())
            continue;
        materials::ReliefMaterial& material =
            materials_.back().emplace(reliefOf(part.sample, size).maps, technique);
        material.depthScale = part.depthScale;
        material.window = glm::vec4(part.mesh.windowMinimum, part.mesh.windowMaximum);
        material.pixelRays = 1;  // as lookups are counted
    }
}

const StagedScene::Relief& StagedScene::reliefOf(std::string_view sample, int size) {
    if (const auto found = reliefs_.find(sample); found != reliefs_.end())
        return found->second;
    textures::DepthMap map = textures::generateSampleRelief(std::string(sample), size, size);
    auto maps = std::make_shared<materials::ReliefMaps>(
        preprocess::bakeRelief(map, planFor(technique_)), std::string(sample));
    return reliefs_.emplace(sample, Relief{std::move(map), std::move(maps)}).first->second;
}

void StagedScene::setParameter(std::string_view name, double value) {
    for (std::optional<materials::ReliefMaterial>& material : materials_)
        if (material)
            material->setParameter(name, value);
}

std::vector<viewer::SceneObject> StagedScene::objects() const {
    std::vector<viewer::SceneObject> objects(model_.parts.size());
    for (std::size_t k = 0; k < objects.size(); ++k) {
        objects[k].surface = &surfaces_[k];
        if (materials_[k])
            objects[k].material = &*materials_[k];
    }
    return objects;
}

std::vector<viewer::ExactObject> StagedScene::exactObjects() const {
    std::vector<viewer::ExactObject> objects;
    for (const ScenePart& part : model_.parts) {
        viewer::ExactObject object;
        object.mesh = &part.mesh;
        if (!part.sample.empty())
            object.relief = &reliefs_.at(part.sample).map;
        object.depthScale = static_cast<double>(part.depthScale);
        object.window = glm::dvec4(part.mesh.windowMinimum, part.mesh.windowMaximum);
        objects.push_back(object);
    }
    return objects;
}

}  // namespace relievo::bench
