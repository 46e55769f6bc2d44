#include "viewer/frame_renderer.h"

#include <optional>
#include <string_view>
#include <vector>

#include "materials/detail_choice.h"
#include "shaders/relievo/constants.h"

namespace relievo::viewer {
namespace {

constexpr std::string_view kShaded = "relievo/programs/shaded.frag";
constexpr std::string_view kPlain = "relievo/programs/plain.frag";
constexpr std::string_view kMeasured = "relievo/programs/measured.frag";

void prepare(gl::Framebuffer& target) {
    target.bind();
    target.clearDepth();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

// What every program of a relief needs. Returns the first texture unit that stays free.
GLuint bindMaterial(gl::Program& program, const SceneObject& object) {
    GLuint unit = object.material->bind(program.id());
    if (object.givenHits) {
        program.set("relievoGivenHits", static_cast<int>(unit));
        object.givenHits->bind(unit++);
    }
    return unit;
}

// The object's material, as `auto` chooses it for this view.
std::optional<materials::ReliefMaterial> chosenMaterial(const SceneObject& object,
                                                        const Camera& camera, int width,
                                                        int height) {
    if (!object.material)
        return std::nullopt;
    return materials::materialForDraw(*object.material, object.surface->extent(),
                                      {camera.viewProjection, glm::vec2(width, height)});
}

void drawObject(gl::Program& program, const SceneObject& object, const Camera& camera) {
    program.set("viewProjection", camera.viewProjection);
    program.set("eye", camera.eye);
    program.use();
    object.surface->draw();
}

}  // namespace

gl::Program& FrameRenderer::shadedProgram(const SceneObject& object, const FrameView& view) {
    if (!object.material)
        return programs_.get(kPlain, "", {});
    std::vector<shaders::Define> defines = object.material->defines();
    if (object.albedo)
        defines.push_back({"RELIEVO_ALBEDO", "1"});
    if (view.markExhausted)
        defines.push_back({"RELIEVO_MARK_EXHAUSTED", "1"});
    return programs_.get(kShaded, object.material->technique().file, defines);
}

void FrameRenderer::draw(std::span<const SceneObject> objects, const FrameView& view,
                         gl::Framebuffer& target) {
    prepare(target);
    target.clearColor(0, 0.09f, 0.09f, 0.1f, 1.0f);
    for (SceneObject object : objects) {
        const auto material = chosenMaterial(object, view.camera, target.width(), target.height());
        object.material = material ? &*material : nullptr;
        gl::Program& program = shadedProgram(object, view);
        program.set("toLight", view.toLight);
        if (object.material) {
            const GLuint unit = bindMaterial(program, object);
            if (object.albedo) {
                program.set("albedoMap", static_cast<int>(unit));
                object.albedo->bind(unit);
            }
        } else {
            program.set("plainColor", object.plainColor);
        }
        drawObject(program, object, view.camera);
    }
}

MeasuredFrame FrameRenderer::measure(SceneObject object, const FrameView& view, int width,
                                     int height) {
    gl::Framebuffer target = makeMeasuredTarget(width, height);
    const auto material = chosenMaterial(object, view.camera, width, height);
    object.material = &material.value();
    gl::Program& program =
        programs_.get(kMeasured, material->technique().file, material->defines());
    prepare(target);
    for (int attachment = 0; attachment < RELIEVO_OUTPUT_COUNT; ++attachment)
        target.clearColor(attachment, 0, 0, 0, 0);
    bindMaterial(program, object);
    drawObject(program, object, view.camera);
    return readMeasuredFrame(target);
}

}  // namespace relievo::viewer
