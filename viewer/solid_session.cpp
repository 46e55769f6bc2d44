#include "viewer/solid_session.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

#include "textures/file_extension.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "viewer/carrier_mesh.h"
#include "viewer/texture_files.h"

namespace relievo::viewer {
namespace {

// In distances of a scene's camera: as far as its own picture goes.
constexpr float kSceneReach = 4.0f;

// The space of the whole of a box around the origin, as box_placement.h has it, for several tiles.
glm::dmat4 boxFromTiles(const glm::dvec3& size, const glm::dvec3& tiles) {
    glm::dmat4 perTile(1.0);
    for (int axis = 0; axis < 3; ++axis)
        perTile[axis][axis] = 1.0 / tiles[axis];
    return wholeToLocal(size) * perTile;
}

surfaces::SurfaceMesh meshOf(const ViewOptions& options, const SolidPlace& place) {
    if (place.object == ObjectKind::ShapeBox)
        return surfaces::makeShapeBox(glm::dvec3(0.0), place.tiles,
                                      boxFromTiles(place.boxSize, place.tiles));
    return makeCarrier(options, static_cast<float>(place.tileAspect));
}

void putInto(materials::SolidMaterial& material, const ViewOptions& options,
             const SolidPlace& place) {
    const bool isInBox = place.object == ObjectKind::ShapeBox;
    const glm::dvec4 window(carrierWindow(options));
    material.low = isInBox ? glm::dvec3(0.0) : glm::dvec3(window.x, window.y, 0.0);
    material.high = isInBox ? place.tiles : glm::dvec3(window.z, window.w, 1.0);
    material.boxFromWhole.reset();
    if (isInBox)
        material.boxFromWhole = boxFromTiles(place.boxSize, place.tiles);
}

// The solid goes as far as its carrier does.
solids::Compound compoundFor(const ViewOptions& options,
                             const std::shared_ptr<const textures::ShapeMap>& shape) {
    solids::Compound compound = compoundOf(options.solid, shape, options.tiles);
    if (isWithoutBorders(options.object))
        for (solids::SolidPart& part : compound.parts) {
            const glm::dvec4 window(carrierWindow(options));
            part.windowMinimum = {window.x, window.y, part.windowMinimum.z};
            part.windowMaximum = {window.z, window.w, part.windowMaximum.z};
        }
    return compound;
}

// Other techniques of a comparison may have other parameters.
bool concerns(const ParameterSetting& setting, const materials::Technique& technique) {
    return (setting.technique.empty() || setting.technique == technique.name) &&
           std::ranges::any_of(technique.parameters,
                               [&](const auto& info) { return info.name == setting.name; });
}

}  // namespace

bool isSceneFile(const std::string& file) {
    return textures::lowerExtension(file) == ".json";
}

void takeSceneView(const SceneFile& scene, ViewOptions& options) {
    if (!options.sceneOptions.contains("camera"))
        options.camera = scene.camera;
    options.camera.reach = std::max(options.camera.reach, kSceneReach * scene.camera.distance);
    if (!options.sceneOptions.contains("light"))
        options.light = {scene.light.azimuth, scene.light.elevation};
}

SolidPlace placeOf(const ViewOptions& options, const textures::ShapeMap& shape) {
    const bool isRevolution = options.solid.kind == solids::SolidKind::Revolution;
    SolidPlace place;
    place.object = options.object;
    place.tiles = glm::dvec3(options.tiles, isRevolution ? options.solid.depthTiles : 1);
    if (options.object == ObjectKind::ShapeBox)
        place.boxSize = boxSizeOf(options.solid, shape, options.tiles, options.depthScale);
    else if (!isRevolution)
        place.tileAspect = shape.aspect();
    if (options.object == ObjectKind::ShapeBox && !(place.boxSize.z > 0.0))
        throw textures::InputError("a shape box without a depth, expected a depth scale above 0");
    return place;
}

textures::WrapMode wrapModeFor(const ViewOptions& options) {
    const bool isTiled = isWithoutBorders(options.object) ||
                         glm::any(glm::greaterThan(options.tiles, glm::vec2(1.0f)));
    return isTiled && options.solid.kind == solids::SolidKind::Extrusion
               ? textures::WrapMode::Repeat
               : textures::WrapMode::Clamp;
}

SolidSession::SolidSession(const ViewOptions& options, const materials::SolidTechnique& technique)
    : technique_(&technique) {
    const std::string file = options.files.front().string();
    if (isSceneFile(file)) {
        scene_ = readSceneFile(file);
        stage_ = std::make_unique<SolidStage>(technique);
        stage_->add(*scene_);
    }
    edit(options);
}

void SolidSession::edit(const ViewOptions& options) {
    steps_.reset();
    if (!scene_)
        followShape(options);
    setParameters(options.parameters);
}

std::shared_ptr<const textures::ShapeMap> SolidSession::shapeFor(const ViewOptions& options) {
    std::shared_ptr<const textures::ShapeMap>& shape = shapes_[wrapModeFor(options)];
    if (!shape)
        shape = openShape(options.files.front().string(), wrapModeFor(options));
    return shape;
}

void SolidSession::followShape(const ViewOptions& options) {
    const std::shared_ptr<const textures::ShapeMap> shape = shapeFor(options);
    const SolidPlace place = placeOf(options, *shape);
    shape_ = shape;
    if (!material_ || material_->compound.parts.front().solid.kind != options.solid.kind) {
        stageShape(options, place);
    } else if (place != place_) {
        stage_->setSurface(*material_, meshOf(options, place));
        place_ = place;
    }
    putInto(*material_, options, place);
    material_->compound = compoundFor(options, shape_);
    material_->depthScale = options.depthScale;
    material_->hasFloor = options.solid.hasFloor;
    material_->looks.front().texturing = options.solid.texturing;
    material_->pictureTiles = options.solid.pictureTiles;
    if (material_->relief)
        material_->relief->depthScale = options.solid.wallDepth;
    material_->shadowsItself = options.shadow != kNoShadow || material_->isInBox();
}

// A material keeps the kinds of its parts.
void SolidSession::stageShape(const ViewOptions& options, const SolidPlace& place) {
    materials::TextureSet textures;
    const auto albedo = options.textures.find("albedo");
    if (albedo != options.textures.end())
        textures = readTextureSet({{"albedo", albedo->second}}, false, {}, albedo->second.string());
    auto stage = std::make_unique<SolidStage>(*technique_);
    material_ = &stage->addSurface(compoundFor(options, shape_), meshOf(options, place),
                                   std::move(textures));
    stage_ = std::move(stage);
    place_ = place;
    if (!options.solid.wallRelief.empty())
        stage_->putRelief(*material_, options.solid.wallRelief, options.solid.wallTechnique);
}

void SolidSession::setParameters(const std::vector<ParameterSetting>& settings) {
    const materials::Technique& technique = technique_->technique;
    for (const materials::TechniqueParameter& parameter : technique.parameters)
        stage_->setParameter(parameter.name, parameter.defaultValue);
    for (const ParameterSetting& setting : settings)
        if (concerns(setting, technique))
            stage_->setParameter(setting.name, setting.value);
    if (parameters_ != settings)
        shadows_.reset();
    parameters_ = settings;
}

FrameView SolidSession::viewOf(const ViewOptions& options, const gl::Framebuffer& target) const {
    return viewOf(options,
                  static_cast<float>(target.width()) / static_cast<float>(target.height()));
}

FrameView SolidSession::viewOf(const ViewOptions& options, float aspect) const {
    FrameView view;
    view.camera = perspectiveCamera(options.camera, aspect);
    view.toLight = directionTowards(options.light.x, options.light.y);
    view.markExhausted = options.markExhausted;
    return view;
}

// A single solid shadows itself by light rays.
const ShadowMap* SolidSession::shadowsFor(const ViewOptions& options) {
    if (!scene_)
        return nullptr;
    if (!shadows_ || shadows_->light != options.light)
        shadows_ = Shadows{options.light,
                           FrameRenderer::emptyShadowMap(
                               lightCamera(options.light, stage_->extent()), options.shadowTexels)};
    return &shadows_->map;
}

void SolidSession::begin(const ViewOptions& options, gl::Framebuffer& target) {
    steps_ = Steps{&target, stage_->objects(options.shading), viewOf(options, target)};
    steps_->view.shadowMap = shadowsFor(options);
    FrameRenderer::clear(steps_->view.camera, target);
}

bool SolidSession::step() {
    const std::span<const SceneObject> objects(steps_->objects);
    if (shadows_ && shadows_->casters < objects.size())
        frames_.addShadows(objects.subspan(shadows_->casters++, 1), shadows_->map);
    else if (steps_->drawn < objects.size())
        frames_.add(objects.subspan(steps_->drawn++, 1), steps_->view, *steps_->target);
    return steps_->drawn < objects.size();
}

SolidProgress SolidSession::progress() const {
    const std::size_t count = steps_->objects.size();
    const bool isOfShadows = shadows_ && shadows_->casters < count;
    return {isOfShadows, isOfShadows ? shadows_->casters : steps_->drawn, count};
}

void SolidSession::draw(const ViewOptions& options, gl::Framebuffer& target) {
    begin(options, target);
    while (step())
        ;
}

void SolidSession::draft(const ViewOptions& options, gl::Framebuffer& target) {
    FrameView view = viewOf(options, target);
    view.shadowMap = shadowsFor(options);
    frames_.draw(stage_->objects(options.shading), view, target);
}

void SolidSession::showUnfinished(const gl::Framebuffer& shown) {
    const int width = shown.width();
    const int height = shown.height();
    glBlitNamedFramebuffer(steps_->target->id(), shown.id(), 0, 0, width, height, 0, 0, width,
                           height, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    std::vector<SceneObject> missing(
        steps_->objects.begin() + static_cast<std::ptrdiff_t>(steps_->drawn),
        steps_->objects.end());
    for (SceneObject& object : missing)
        if (const materials::SolidMaterial* solid = std::exchange(object.solid, nullptr))
            object.plainColor = solid->looks.front().color;
    FrameView view = steps_->view;
    view.shadowMap = nullptr;
    frames_.add(missing, view, shown);
}

MeasuredFrame SolidSession::measure(const ViewOptions& options, int width, int height) {
    const std::vector<SceneObject> objects = stage_->objects(options.shading);
    return frames_.measure(objects.front(),
                           viewOf(options, static_cast<float>(width) / static_cast<float>(height)),
                           width, height);
}

SolidErrors SolidSession::errorsOf(const MeasuredFrame& frame, const ViewOptions& options) const {
    const bool isInBox = place_.object == ObjectKind::ShapeBox;
    const glm::dvec3 tile =
        isInBox ? place_.boxSize / place_.tiles
                : glm::dvec3(1.0, place_.tileAspect, static_cast<double>(options.depthScale));
    const SolidMetric metric{static_cast<double>(shape_->width()) / tile.x * tile,
                             !isInBox && options.solid.hasFloor};
    return measureSolidErrors(frame, material_->compound, metric);
}

}  // namespace relievo::viewer
