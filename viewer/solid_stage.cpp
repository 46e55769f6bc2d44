#include "viewer/solid_stage.h"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "preprocess/shape_baker.h"
#include "textures/map_file.h"
#include "viewer/texture_files.h"

namespace relievo::viewer {
namespace {

// How much of a shadow map the room takes, along each side: the outermost texels see nothing.
constexpr float kLitShare = 0.98f;

bool isBaked(const std::string& source) {
    return std::filesystem::exists(source) && std::filesystem::path(source).extension() != ".svg" &&
           textures::isMapFile(source);
}

std::shared_ptr<const textures::ShapeMap> openShape(const SceneShape& shape) {
    std::string source = shape.file.string();
    if (shape.source == ShapeSource::Text)
        source += ":" + shape.text;
    return viewer::openShape(source, shape.wrap, shape.width);
}

ShapeMaps openShapes(const SceneFile& scene) {
    ShapeMaps maps;
    for (const auto& [name, shape] : scene.shapes)
        maps[name];
    tbb::parallel_for_each(
        maps, [&](auto& entry) { entry.second = openShape(scene.shapes.at(entry.first)); });
    return maps;
}

materials::TextureSet albedoOf(const std::filesystem::path& picture) {
    if (picture.empty())
        return {};
    return readTextureSet({{"albedo", picture}}, false, {}, picture.string());
}

}  // namespace

std::shared_ptr<const textures::ShapeMap> openShape(const std::string& source,
                                                    textures::WrapMode wrap, int width) {
    if (isBaked(source)) {
        try {
            return std::make_shared<textures::ShapeMap>(
                textures::shapeMapOf(textures::readMapFile(source)));
        } catch (const textures::InputError& error) {
            throw textures::InputError(source + ": " + error.what());
        }
    }
    preprocess::ShapePlan plan;
    plan.wrap = wrap;
    plan.width = width;
    return std::make_shared<textures::ShapeMap>(preprocess::bakeShapeFile(source, plan));
}

SolidStage::SolidStage(const materials::SolidTechnique& technique)
    : technique_(&technique), shapes_(std::make_shared<materials::ShapeTextureCache>()) {}

surfaces::SurfaceExtent SolidStage::extent() const {
    std::optional<surfaces::SurfaceExtent> all;
    for (const Mesh& mesh : meshes_) {
        if (!mesh.solid)
            continue;
        const surfaces::SurfaceExtent& extent = mesh.surface.extent();
        if (!all)
            all = extent;
        all->minimum = glm::min(all->minimum, extent.minimum);
        all->maximum = glm::max(all->maximum, extent.maximum);
    }
    return all.value_or(surfaces::SurfaceExtent());
}

void SolidStage::putRelief(materials::SolidMaterial& solid, const std::filesystem::path& map,
                           std::string_view technique) {
    std::shared_ptr<materials::ReliefMaps>& maps = reliefs_[map];
    if (!maps)
        maps = std::make_shared<materials::ReliefMaps>(textures::readMapLevels(map), map.string());
    solid.relief.emplace(maps, materials::findTechnique(technique));
}

void SolidStage::putRelief(materials::SolidMaterial& solid, const SceneRelief& relief) {
    try {
        putRelief(solid, relief.map, relief.technique);
    } catch (const textures::InputError& error) {
        throw textures::InputError(relief.place + ": " + error.what());
    }
    solid.relief->depthScale = static_cast<float>(relief.depth);
}

void SolidStage::setSurface(const materials::SolidMaterial& solid,
                            const surfaces::SurfaceMesh& mesh) {
    const auto holder = std::ranges::find_if(
        meshes_, [&](const Mesh& entry) { return entry.solid && &*entry.solid == &solid; });
    holder->surface = SurfaceBuffers(mesh);
}

materials::SolidMaterial& SolidStage::addBox(solids::Compound compound, const glm::dvec3& low,
                                             const glm::dvec3& high, const glm::dmat4& boxFromWhole,
                                             materials::TextureSet textures) {
    materials::SolidMaterial& material = addSurface(
        std::move(compound), surfaces::makeShapeBox(low, high, boxFromWhole), std::move(textures));
    material.low = low;
    material.high = high;
    material.boxFromWhole = boxFromWhole;
    return material;
}

materials::SolidMaterial& SolidStage::addSurface(solids::Compound compound,
                                                 const surfaces::SurfaceMesh& mesh,
                                                 materials::TextureSet textures) {
    Mesh& added = meshes_.emplace_back(
        Mesh{SurfaceBuffers(mesh), materials::SurfaceTextures(std::move(textures)), {}, {}});
    materials::SolidMaterial& material =
        added.solid.emplace(shapes_, std::move(compound), *technique_);
    material.low = {mesh.windowMinimum.x, mesh.windowMinimum.y, 0.0};
    material.high = {mesh.windowMaximum.x, mesh.windowMaximum.y, 1.0};
    solids_.push_back(&material);
    return material;
}

void SolidStage::addPlain(const surfaces::SurfaceMesh& mesh, const glm::vec3& color,
                          materials::TextureSet textures) {
    meshes_.push_back(
        Mesh{SurfaceBuffers(mesh), materials::SurfaceTextures(std::move(textures)), color, {}});
}

void SolidStage::addBoxes(const SceneBox& box, const ShapeMaps& shapes) {
    for (const glm::dmat4& place : box.wholeToWorld) {
        materials::SolidMaterial& material = addBox(compoundOf(box, shapes), glm::dvec3(0.0),
                                                    glm::dvec3(1.0), place, albedoOf(box.picture));
        for (std::size_t k = 0; k < box.parts.size(); ++k)
            material.looks[k] = {box.parts[k].colour, box.texturing};
        material.pictureTiles = box.pictureTiles;
        if (box.relief)
            putRelief(material, *box.relief);
    }
}

void SolidStage::addQuads(const SceneQuad& quad) {
    const auto aspect = static_cast<float>(quad.size.y / quad.size.x);
    for (const glm::dmat4& place : quad.localToWorld) {
        glm::mat4 placement(place);
        for (int axis = 0; axis < 3; ++axis)
            placement[axis] *= static_cast<float>(quad.size.x);
        addPlain(surfaces::placed(surfaces::makeQuad({1.0f, 1.0f}, aspect), placement), quad.colour,
                 albedoOf(quad.picture));
    }
}

void SolidStage::add(const SceneFile& scene) {
    const ShapeMaps shapes = openShapes(scene);
    for (const SceneBox& box : scene.boxes)
        addBoxes(box, shapes);
    for (const SceneQuad& quad : scene.quads)
        addQuads(quad);
}

void SolidStage::setParameter(std::string_view name, double value) {
    for (materials::SolidMaterial* solid : solids_)
        solid->setParameter(name, value);
}

std::vector<SceneObject> SolidStage::objects(const materials::Shading& shading) {
    std::vector<SceneObject> objects;
    for (Mesh& mesh : meshes_) {
        SceneObject& object = objects.emplace_back();
        object.surface = &mesh.surface;
        object.solid = mesh.solid ? &*mesh.solid : nullptr;
        object.textures = &mesh.textures;
        object.shading = shading;
        object.plainColor = mesh.color;
    }
    return objects;
}

Camera lightCamera(const glm::vec2& light, const surfaces::SurfaceExtent& extent) {
    OrbitCamera orbit;
    orbit.azimuth = light.x;
    orbit.elevation = light.y;
    orbit.target = 0.5f * (extent.minimum + extent.maximum);
    const float radius = std::max(0.5f * glm::distance(extent.minimum, extent.maximum), 1e-3f);
    orbit.distance = 1.5f * radius;
    orbit.reach = 1.5f * radius;
    orbit.fieldOfView = glm::degrees(2.0f * std::atan(1.0f / 1.5f));
    Camera camera = orthographicCamera(orbit, 1.0f);
    // It holds the sphere around the room, in the middle of which the target is: as wide and high
    // as the room itself is seen.
    const glm::mat3 across(camera.viewProjection);
    const glm::vec3 half = 0.5f * (extent.maximum - extent.minimum);
    glm::vec3 seen(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        seen += half[axis] * glm::abs(across[axis]);
    const glm::vec3 scale(kLitShare / glm::max(glm::vec2(seen), glm::vec2(1e-3f)), 1.0f);
    camera.viewProjection = glm::scale(glm::mat4(1.0f), scale) * camera.viewProjection;
    return camera;
}

}  // namespace relievo::viewer
