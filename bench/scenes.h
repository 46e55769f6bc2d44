#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "materials/relief_maps.h"
#include "materials/technique_registry.h"
#include "surfaces/surface_mesh.h"
#include "textures/depth_map.h"
#include "viewer/camera.h"
#include "viewer/exact_scene.h"
#include "viewer/frame_renderer.h"

namespace relievo::bench {

/// An object of a scene.
struct ScenePart {
    surfaces::SurfaceMesh mesh;
    std::string_view sample;  ///< name of its relief among textures::sampleReliefs; "": plain mesh
    float depthScale = 0.0f;
};

/// Several objects, from where they are seen and from where they are lit.
struct SceneModel {
    std::vector<ScenePart> parts;
    viewer::OrbitCamera eye;
    viewer::OrbitCamera light;  ///< far away, in that direction; its frame holds the scene
};

/// "hidden": a floor, a far wall, and a box behind the wall. "intersections": two reliefs that pass
/// through each other, and a plain box in both.
std::span<const std::string_view> sceneNames();

/// The scene of that name, which must be one of sceneNames().
SceneModel sceneModel(std::string_view name);

/// A scene on the graphics processor, all of its reliefs shown by one technique, and the same for
/// the exact reference. The model must be there as long. Needs a current context.
class StagedScene {
  public:
    /// The reliefs have size² texels.
    StagedScene(const SceneModel& model, const materials::Technique& technique, int size);

    /// Sets a parameter of the technique for every relief.
    void setParameter(std::string_view name, double value);
    /// These point into the scene.
    [[nodiscard]] std::vector<viewer::SceneObject> objects() const;
    [[nodiscard]] std::vector<viewer::ExactObject> exactObjects() const;

  private:
    struct Relief {
        textures::DepthMap map;
        std::shared_ptr<materials::ReliefMaps> maps;
    };
    const Relief& reliefOf(std::string_view sample, int size);

    const SceneModel& model_;
    const materials::Technique& technique_;
    std::map<std::string_view, Relief> reliefs_;
    std::vector<viewer::SurfaceBuffers> surfaces_;
    std::vector<std::optional<materials::ReliefMaterial>> materials_;  // one a part
};

}  // namespace relievo::bench
