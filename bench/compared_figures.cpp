#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench/figure_shapes.h"
#include "bench/solid_figures.h"
#include "bench/technique_maps.h"
#include "materials/relief_material.h"
#include "preprocess/relief_baker.h"
#include "textures/depth_map.h"

namespace relievo::bench {
namespace {

constexpr float kDepth = 0.3f;  // in tile widths
constexpr float kTiles = 2.0f;
// Elevations of the eye, and how far away it is.
constexpr std::array kEyes = {glm::vec2(32.0f, 1.7f), glm::vec2(13.0f, 1.35f)};

std::string lookups(const viewer::MeasuredFrame& frame) {
    const viewer::WorkCounts work = viewer::countWork(frame);
    std::string text = fmt::format("{:.1f} lookups a pixel", work.meanFetches);
    if (work.exhausted > 0)
        text += fmt::format(", {} ran out", work.exhausted);
    return text;
}

// Depth 0 inside of a shape, 1 outside.
textures::DepthMap depthsOf(const textures::ShapeMap& shape) {
    textures::DepthMap relief;
    relief.depth = textures::Plane(shape.width(), shape.height());
    relief.wrap = shape.wrap;
    std::ranges::transform(shape.distance.texels, relief.depth.texels.begin(),
                           [](float distance) { return distance > 0.0f ? 1.0f : 0.0f; });
    return relief;
}

viewer::FrameView viewFrom(const FigureFrames& frames, const glm::vec2& from) {
    const viewer::OrbitCamera eye{.azimuth = 20,
                                  .elevation = from.x,
                                  .distance = from.y,
                                  .fieldOfView = 30,
                                  .target = {0.0f, 0.0f, 0.0f}};
    viewer::FrameView view;
    view.camera = viewer::perspectiveCamera(
        eye, static_cast<float>(frames.width) / static_cast<float>(frames.height));
    view.toLight = viewer::directionTowards(-50, 40);
    return view;
}

viewer::SheetCell cellOf(FigureFrames& frames, const viewer::SceneObject& object,
                         const glm::vec2& from, std::string title) {
    const viewer::FrameView view = viewFrom(frames, from);
    gl::Framebuffer target(kFigureRays * frames.width, kFigureRays * frames.height,
                           std::array<GLenum, 1>{GL_RGBA8});
    frames.renderer.draw({&object, 1}, view, target);
    return {averagedPicture(target), std::move(title),
            lookups(frames.renderer.measure(object, view, frames.width, frames.height))};
}

}  // namespace

std::vector<FigureRow> comparedFigures(FigureFrames& frames) {
    const auto shape = figureShape("flower", frames.texels, textures::WrapMode::Repeat);
    const surfaces::SurfaceMesh mesh = surfaces::makeQuad({kTiles, kTiles}, 1.0f);
    const viewer::SurfaceBuffers surface(mesh);
    std::vector<FigureRow> rows(kEyes.size());
    for (const char* name : {"relief", "parallax-occlusion", "cone"}) {
        const materials::Technique& technique = materials::findTechnique(name);
        materials::ReliefMaterial material(
            std::make_shared<materials::ReliefMaps>(
                preprocess::bakeRelief(depthsOf(*shape), planFor(technique)), name),
            technique);
        material.depthScale = kDepth;
        material.window = glm::vec4(mesh.windowMinimum, mesh.windowMaximum);
        material.pixelRays = 1;
        viewer::SceneObject object;
        object.surface = &surface;
        object.material = &material;
        for (std::size_t k = 0; k < rows.size(); ++k)
            rows[k].push_back(
                cellOf(frames, object, kEyes[k], fmt::format("4.18 {}", technique.title)));
    }
    FigureStage figure(frames);
    figure
        .addSunk(extrusionOf(shape, solids::makeProfile(0.0), glm::dvec2(kTiles)), mesh, kDepth,
                 glm::vec3(0.6f))
        .shadowsItself = false;
    const std::vector<viewer::SceneObject> objects = figure.stage().objects({});
    for (std::size_t k = 0; k < rows.size(); ++k)
        rows[k].push_back(cellOf(frames, objects.front(), kEyes[k], "4.18 extrusion"));
    return rows;
}

}  // namespace relievo::bench
