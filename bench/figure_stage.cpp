#include "bench/figure_stage.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "bench/sheet_view.h"
#include "materials/solid_registry.h"
#include "viewer/box_placement.h"
#include "viewer/temporal_error.h"

namespace relievo::bench {
namespace {

constexpr int kMostShadowTexels = 2048;
constexpr int kShadowTexelsOfPixel = 8;
constexpr glm::vec3 kGroundColor{0.36f, 0.36f, 0.38f};

// Copies what an object covers of its own picture.
void pasteCovered(viewer::Picture& picture, const gl::Framebuffer& drawn) {
    const std::vector<float> colors = drawn.read(0);
    const std::vector<float> depths = drawn.readDepth();
    for (std::size_t k = 0; k < depths.size(); ++k)
        if (depths[k] < 1.0f)
            std::copy_n(&colors[4 * k], 4, &picture.rgba[4 * k]);
}

}  // namespace

glm::dmat4 BoxPlace::fromLocal() const {
    return viewer::localToWorld(position, degrees);
}

glm::dmat4 BoxPlace::fromTiles(const glm::dvec3& tiles) const {
    return fromLocal() * viewer::wholeToLocal(size) * glm::scale(glm::dmat4(1.0), 1.0 / tiles);
}

solids::SolidPart extrusionOf(std::shared_ptr<const textures::ShapeMap> shape,
                              const solids::Profile& profile, const glm::dvec2& tiles) {
    solids::SolidPart part;
    part.solid.shape = std::move(shape);
    part.solid.profile = profile;
    part.windowMaximum = glm::dvec3(tiles, 1.0);
    return part;
}

solids::SolidPart revolutionOf(std::shared_ptr<const textures::ShapeMap> shape,
                               const glm::dvec2& tiles) {
    solids::SolidPart part = extrusionOf(std::move(shape), solids::makeProfile(0.0), tiles);
    part.solid.kind = solids::SolidKind::Revolution;
    return part;
}

viewer::Picture averagedPicture(const gl::Framebuffer& target) {
    return viewer::averaged(pictureIn(target), kFigureRays);
}

FigureStage::FigureStage(FigureFrames& frames)
    : frames_(frames), stage_(materials::solidTechniques().front()) {}

materials::SolidMaterial& FigureStage::addBox(const solids::SolidPart& part, const BoxPlace& place,
                                              const glm::vec3& color) {
    const glm::dvec3 tiles = part.windowMaximum;
    materials::SolidMaterial& material =
        stage_.addBox({{part}}, glm::dvec3(0.0), tiles, place.fromTiles(tiles));
    material.looks.front().color = color;
    return material;
}

materials::SolidMaterial& FigureStage::addSunk(const solids::SolidPart& part,
                                               const surfaces::SurfaceMesh& mesh, double depth,
                                               const glm::vec3& color) {
    materials::SolidMaterial& material = stage_.addSurface({{part}}, mesh);
    material.depthScale = static_cast<float>(depth);
    material.looks.front().color = color;
    return material;
}

void FigureStage::addBlock(const BoxPlace& place, const glm::vec3& color) {
    const glm::mat4 placement(glm::scale(place.fromLocal(), place.size));
    stage_.addPlain(surfaces::placed(surfaces::makeBox({1, 1}), placement), color);
}

void FigureStage::addEdges(const BoxPlace& place, double thickness) {
    // In the box's own axes u grows along x, v against y and z against z.
    const glm::dvec3 origin(-0.5, 0.5, 0.5);
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {-0.5, 0.5})
            for (const double b : {-0.5, 0.5}) {
                glm::dvec3 middle(0.0);
                middle[(axis + 1) % 3] = a;
                middle[(axis + 2) % 3] = b;
                const bool isAxis = a == origin[(axis + 1) % 3] && b == origin[(axis + 2) % 3];
                BoxPlace edge;
                edge.size = glm::dvec3(isAxis ? 2.0 * thickness : thickness);
                edge.size[axis] = place.size[axis] + thickness;
                edge.position = glm::dvec3(place.fromLocal() * glm::dvec4(middle * place.size, 1));
                edge.degrees = place.degrees;
                glm::vec3 color(isAxis ? 0.02f : 0.5f);
                if (isAxis)
                    color[axis] = 0.7f;
                addBlock(edge, color);
            }
}

void FigureStage::addGround(double height) {
    constexpr float kWidth = 100.0f;
    const glm::mat4 lowered =
        glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, static_cast<float>(height)));
    stage_.addPlain(
        surfaces::placed(surfaces::makeQuad({1, 1}, 1), glm::scale(lowered, glm::vec3(kWidth))),
        kGroundColor);
}

viewer::FrameView FigureStage::view() const {
    viewer::FrameView view;
    view.camera = viewer::perspectiveCamera(
        eye, static_cast<float>(frames_.width) / static_cast<float>(frames_.height));
    view.toLight = viewer::directionTowards(light.x, light.y);
    view.markExhausted = true;
    return view;
}

gl::Framebuffer FigureStage::makeTarget() const {
    return {kFigureRays * frames_.width, kFigureRays * frames_.height,
            std::array<GLenum, 1>{GL_RGBA8}};
}

viewer::Picture FigureStage::draw() {
    const std::vector<viewer::SceneObject> objects = stage_.objects({});
    viewer::FrameView shown = view();
    std::optional<viewer::ShadowMap> shadow;
    if (throwsShadows) {
        shadow.emplace(frames_.renderer.castShadows(
            objects, viewer::lightCamera(light, stage_.extent()),
            std::min(kMostShadowTexels, kShadowTexelsOfPixel * frames_.width)));
        shown.shadowMap = &*shadow;
    }
    gl::Framebuffer target = makeTarget();
    frames_.renderer.draw(objects, shown, target);
    return averagedPicture(target);
}

viewer::Picture FigureStage::drawInOrder() {
    gl::Framebuffer target = makeTarget();
    frames_.renderer.draw({}, view(), target);
    viewer::Picture picture = pictureIn(target);
    for (const viewer::SceneObject& object : stage_.objects({})) {
        frames_.renderer.draw({&object, 1}, view(), target);
        pasteCovered(picture, target);
    }
    return viewer::averaged(picture, kFigureRays);
}

}  // namespace relievo::bench
