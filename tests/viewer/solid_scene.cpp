#include "solid_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "materials/solid_registry.h"
#include "relief_scene.h"

namespace relievo::viewer {
namespace {

constexpr float kElevations[] = {90.0f, 45.0f, 15.0f, 5.0f, 1.0f, 0.1f};
constexpr float kBoxElevations[] = {90.0f, 45.0f, 5.0f, 0.1f, 0.0f, -1.0f, -30.0f, -90.0f};
constexpr float kAzimuths[] = {0.0f, 30.0f, 135.0f, 261.0f};

// The box in the world: u along +x, v along −y, z down.
glm::dmat4 boxFromWhole(const SolidCase& solid) {
    const glm::dvec3 scale(1.0, -1.0, -solid.depth);
    const glm::dvec3 middle = 0.5 * (solid.low + solid.high);
    return glm::translate(glm::scale(glm::dmat4(1.0), scale), -middle);
}

double aspectOf(const SolidCase& solid) {
    return solid.compound.parts.front().solid.shape->aspect();
}

surfaces::SurfaceMesh meshOf(const SolidCase& solid) {
    if (solid.isInBox)
        return surfaces::makeShapeBox(solid.low, solid.high, boxFromWhole(solid));
    return surfaces::makeQuad({1, 1}, static_cast<float>(aspectOf(solid)));
}

}  // namespace

SolidTestStage::SolidTestStage()
    : context(makeTestContext()),
      shapes(std::make_shared<materials::ShapeTextureCache>()),
      frames(std::make_unique<FrameRenderer>()) {}

SolidTestStage::~SolidTestStage() = default;

SolidScene::SolidScene(SolidTestStage& stage, const SolidCase& solidCase)
    : material(stage.shapes, solidCase.compound, materials::findSolidTechnique("solid")),
      stage_(stage),
      case_(solidCase),
      surface_(std::make_unique<SurfaceBuffers>(meshOf(solidCase))) {
    material.low = case_.low;
    material.high = case_.high;
    material.hasFloor = false;
    material.depthScale = static_cast<float>(case_.depth);
    if (case_.isInBox)
        material.boxFromWhole = boxFromWhole(case_);
}

MeasuredFrame SolidScene::measure(const Camera& camera, int size) {
    FrameView view;
    view.camera = camera;
    view.toLight = directionTowards(-50, 40);
    SceneObject object;
    object.surface = surface_.get();
    object.solid = &material;
    return stage_.frames->measure(object, view, size, size);
}

std::vector<Camera> SolidScene::cameras() const {
    std::vector<Camera> result;
    if (!case_.isInBox) {
        for (const float elevation : kElevations)
            for (const float azimuth : kAzimuths)
                result.push_back(
                    parallelRays(azimuth, elevation, static_cast<float>(aspectOf(case_))));
        return result;
    }
    const glm::dvec3 extent = (case_.high - case_.low) * glm::dvec3(1.0, 1.0, case_.depth);
    OrbitCamera orbit;
    for (const float elevation : kBoxElevations)
        for (const float azimuth : kAzimuths) {
            orbit.azimuth = azimuth;
            orbit.elevation = elevation;
            orbit.distance = 1.4f * static_cast<float>(glm::length(extent));
            result.push_back(orthographicCamera(orbit, 1.0f));
            result.push_back(perspectiveCamera(orbit, 1.0f));
            // Within the box, in what is solid or beside it.
            orbit.distance = 0.3f * static_cast<float>(std::min({extent.x, extent.y, extent.z}));
            orbit.fieldOfView = 90.0f;
            result.push_back(perspectiveCamera(orbit, 1.0f));
            orbit.fieldOfView = 40.0f;
        }
    return result;
}

}  // namespace relievo::viewer
