#include "bench/solid_stages.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "bench/stopwatch.h"
#include "bench/technique_maps.h"
#include "preprocess/relief_baker.h"
#include "surfaces/surface_mesh.h"

namespace relievo::bench {
namespace {

constexpr float kUnbounded = std::numeric_limits<float>::infinity();

// One unit of the world to the widest side of the window, v and z downwards.
glm::dmat4 boxOf(const solids::SolidPart& part) {
    const glm::dvec3 size = part.windowMaximum - part.windowMinimum;
    const glm::dvec3 middle = 0.5 * (part.windowMaximum + part.windowMinimum);
    const double scale = 1.0 / std::max(size.x, size.y);
    return glm::translate(glm::scale(glm::dmat4(1.0), scale * glm::dvec3(1.0, -1.0, -1.0)),
                          -middle);
}

viewer::FrameView squareView(const SolidSight& sight) {
    viewer::FrameView view;
    view.camera = viewer::parallelRays(static_cast<float>(sight.azimuth),
                                       static_cast<float>(sight.elevation), 1.0f);
    return view;
}

// Frames hold as much of a box as a few replicas of a revolution are wide.
viewer::FrameView boxView(const SolidSight& sight, double replicas) {
    viewer::OrbitCamera orbit;
    orbit.azimuth = static_cast<float>(sight.azimuth);
    orbit.elevation = static_cast<float>(sight.elevation);
    orbit.distance = replicas > 1.0 ? 0.5f : 2.0f;
    viewer::FrameView view;
    view.camera = viewer::orthographicCamera(orbit, 1.0f);
    return view;
}

template <typename Draw>
double leastFrameSeconds(int repeat, const Draw& draw) {
    const auto finish = [&draw] {
        draw();
        glFinish();
    };
    // The first frame compiles the program and uploads the maps.
    finish();
    return leastSeconds(repeat, finish);
}

gl::Framebuffer pictureTarget(int frame) {
    return {frame, frame, std::array<GLenum, 1>{GL_RGBA8}};
}

}  // namespace

SolidStage::SolidStage(viewer::FrameRenderer& frames, const solids::SolidPart& part)
    : frames_(frames),
      part_(part),
      shapes_(std::make_shared<materials::ShapeTextureCache>()),
      boxFromWhole_(isInBox() ? std::optional(boxOf(part)) : std::nullopt),
      surface_(boxFromWhole_
                   ? surfaces::makeShapeBox(part.windowMinimum, part.windowMaximum, *boxFromWhole_)
                   : surfaces::makeQuad(surfaces::Tiles(1.0f), 1.0f)) {}

bool SolidStage::isInBox() const {
    return part_.solid.kind == solids::SolidKind::Revolution;
}

SolidSpace SolidStage::space(const SolidSight& sight) const {
    const double aspect = part_.solid.shape->aspect();
    return {aspect, isInBox() ? aspect : sight.depthScale, !isInBox()};
}

SolidRun SolidStage::run(const materials::SolidTechnique& technique, std::optional<int> steps,
                         const SolidSight& sight, int repeat) {
    materials::SolidMaterial material(shapes_, {{part_}}, technique);
    material.low = part_.windowMinimum;
    material.high = part_.windowMaximum;
    material.boxFromWhole = boxFromWhole_;
    material.depthScale = static_cast<float>(sight.depthScale);
    material.shadowsItself = false;
    if (steps)
        material.setParameter(materials::budgetParameter(technique.technique)->name, *steps);
    viewer::SceneObject object;
    object.surface = &surface_;
    object.solid = &material;
    const viewer::FrameView view =
        isInBox() ? boxView(sight, part_.windowMaximum.x) : squareView(sight);
    gl::Framebuffer target = pictureTarget(sight.frame);
    SolidRun run;
    run.seconds = leastFrameSeconds(repeat, [&] { frames_.draw({&object, 1}, view, target); });
    run.frame = frames_.measure(object, view, sight.frame, sight.frame);
    return run;
}

viewer::SceneRenderer& SolidReliefStages::rendererFor(const materials::Technique& technique) {
    const preprocess::ReliefPlan plan = planFor(technique);
    const std::string key = preprocess::optionWords(plan);
    if (const auto found = renderers_.find(key); found != renderers_.end())
        return found->second;
    viewer::SceneRenderer renderer(preprocess::bakeRelief(relief_, plan), "solid", {});
    renderer.setSurface(surfaces::makeQuad(surfaces::Tiles(1.0f), 1.0f));
    return renderers_.emplace(key, std::move(renderer)).first->second;
}

SolidRun SolidReliefStages::run(const materials::Technique& technique, std::optional<int> steps,
                                const SolidSight& sight, int repeat) {
    viewer::SceneRenderer& renderer = rendererFor(technique);
    viewer::View view;
    static_cast<viewer::FrameView&>(view) = squareView(sight);
    view.depthScale = static_cast<float>(sight.depthScale);
    view.window = {-kUnbounded, -kUnbounded, kUnbounded, kUnbounded};
    materials::ReliefMaterial material = renderer.makeMaterial(technique);
    material.pixelRays = 1;  // as errors and lookups are counted
    if (steps)
        material.setParameter(materials::budgetParameter(technique)->name, *steps);
    gl::Framebuffer target = pictureTarget(sight.frame);
    SolidRun run;
    run.seconds = leastFrameSeconds(repeat, [&] { renderer.draw(material, view, target); });
    run.frame = renderer.measure(material, view, sight.frame, sight.frame);
    return run;
}

}  // namespace relievo::bench
