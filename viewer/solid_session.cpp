#include "viewer/solid_session.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "textures/file_extension.h"
#include "textures/map_file.h"
#include "viewer/carrier_mesh.h"
#include "viewer/texture_files.h"

namespace relievo::viewer {
namespace {

constexpr int kShadowTexels = 2048;

// The space of the whole of a box around the origin, as box_placement.h has it, for several tiles.
glm::dmat4 boxFromTiles(const glm::dvec3& size, const glm::dvec3& tiles) {
    glm::dmat4 perTile(1.0);
    for (int axis = 0; axis < 3; ++axis)
        perTile[axis][axis] = 1.0 / tiles[axis];
    return wholeToLocal(size) * perTile;
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

}  // namespace

bool isSceneFile(const std::string& file) {
    return textures::lowerExtension(file) == ".json";
}

void takeSceneView(const SceneFile& scene, ViewOptions& options) {
    if (!options.sceneOptions.contains("camera"))
        options.camera = scene.camera;
    if (!options.sceneOptions.contains("light"))
        options.light = {scene.light.azimuth, scene.light.elevation};
}

SolidSession::SolidSession(const ViewOptions& options, const materials::SolidTechnique& technique) {
    const std::string file = options.files.front().string();
    stage_ = std::make_unique<SolidStage>(technique);
    if (isSceneFile(file))
        openScene(file);
    else
        openShape(options);
}

void SolidSession::openScene(const std::string& file) {
    scene_ = readSceneFile(file);
    stage_->add(*scene_);
}

void SolidSession::openShape(const ViewOptions& options) {
    // A drawing goes on from tile to tile where there are more than one.
    const bool isTiled = isWithoutBorders(options.object) ||
                         glm::any(glm::greaterThan(options.tiles, glm::vec2(1.0f)));
    shape_ = viewer::openShape(options.files.front().string(),
                               isTiled && options.solid.kind == solids::SolidKind::Extrusion
                                   ? textures::WrapMode::Repeat
                                   : textures::WrapMode::Clamp);
    const auto albedo = options.textures.find("albedo");
    materials::TextureSet textures;
    if (albedo != options.textures.end())
        textures = readTextureSet({{"albedo", albedo->second}}, false, {}, albedo->second.string());
    solids::Compound compound = compoundFor(options, shape_);
    if (options.object == ObjectKind::ShapeBox) {
        const glm::dvec3 high = compound.parts.front().windowMaximum;
        const glm::dvec3 size =
            boxSizeOf(options.solid, *shape_, options.tiles, options.depthScale);
        material_ = &stage_->addBox(std::move(compound), glm::dvec3(0.0), high,
                                    boxFromTiles(size, high), std::move(textures));
    } else {
        const float aspect = options.solid.kind == solids::SolidKind::Revolution
                                 ? 1.0f
                                 : static_cast<float>(shape_->aspect());
        material_ = &stage_->addSurface(std::move(compound), makeCarrier(options, aspect),
                                        std::move(textures));
    }
    if (!options.solid.wallRelief.empty())
        openWallRelief(options);
    edit(options);
}

void SolidSession::openWallRelief(const ViewOptions& options) {
    const std::filesystem::path& file = options.solid.wallRelief;
    const auto maps =
        std::make_shared<materials::ReliefMaps>(textures::readMapLevels(file), file.string());
    material_->relief.emplace(maps, materials::findTechnique(options.solid.wallTechnique));
}

void SolidSession::edit(const ViewOptions& options) {
    for (const ParameterSetting& setting : options.parameters)
        stage_->setParameter(setting.name, setting.value);
    if (!material_)
        return;
    material_->compound = compoundFor(options, shape_);
    material_->depthScale = options.depthScale;
    material_->hasFloor = options.solid.hasFloor;
    material_->looks.front().texturing = options.solid.texturing;
    material_->pictureTiles = options.solid.pictureTiles;
    if (material_->relief)
        material_->relief->depthScale = options.solid.wallDepth;
    material_->shadowsItself = options.shadow != kNoShadow || material_->isInBox();
}

FrameView SolidSession::viewOf(const ViewOptions& options, float aspect) const {
    FrameView view;
    view.camera = perspectiveCamera(options.camera, aspect);
    view.toLight = directionTowards(options.light.x, options.light.y);
    view.markExhausted = options.markExhausted;
    return view;
}

void SolidSession::draw(const ViewOptions& options, gl::Framebuffer& target) {
    const std::vector<SceneObject> objects = stage_->objects(options.shading);
    FrameView view =
        viewOf(options, static_cast<float>(target.width()) / static_cast<float>(target.height()));
    // A single solid shadows itself by light rays.
    std::optional<ShadowMap> shadow;
    if (scene_) {
        shadow.emplace(frames_.castShadows(objects, lightCamera(options.light, stage_->extent()),
                                           kShadowTexels));
        view.shadowMap = &*shadow;
    }
    frames_.draw(objects, view, target);
}

MeasuredFrame SolidSession::measure(const ViewOptions& options, int width, int height) {
    const std::vector<SceneObject> objects = stage_->objects(options.shading);
    return frames_.measure(objects.front(),
                           viewOf(options, static_cast<float>(width) / static_cast<float>(height)),
                           width, height);
}

}  // namespace relievo::viewer
