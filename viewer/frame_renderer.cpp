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

void prepare(gl::Framebuffer& target, const DepthConvention& depth) {
    const bool falls = fallsWithDistance(depth);
    target.bind();
    target.clearDepth(falls ? 0.0f : 1.0f);
    glClipControl(GL_LOWER_LEFT, depth.zeroToOne ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    glDepthRangef(depth.range.x, depth.range.y);
    glDepthFunc(falls ? GL_GREATER : GL_LESS);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

// What every program of a relief is made with: also what it must know of the depth buffer
// (relievo/trace.glsl).
std::vector<shaders::Define> reliefDefines(const SceneObject& object, const Camera& camera) {
    std::vector<shaders::Define> defines = object.material->defines();
    if (camera.depth.zeroToOne)
        defines.push_back({"RELIEVO_CLIP_ZERO_TO_ONE", "1"});
    if (fallsWithDistance(camera.depth))
        defines.push_back({"RELIEVO_DEPTH_REVERSED", "1"});
    return defines;
}

// What every program of a relief needs. Returns the first texture unit that stays free.
GLuint bindMaterial(gl::Program& program, const SceneObject& object) {
    GLuint unit = object.material->bind(program.id());
    if (object.givenHits) {
        program.set("relievoGivenHits", static_cast<int>(unit));
        object.givenHits->bind(unit++);
    }
    if (object.givenVisibility) {
        program.set("relievoGivenVisibility", static_cast<int>(unit));
        object.givenVisibility->bind(unit++);
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

// Programs of hard shadows have no use for the radius.
void setLight(gl::Program& program, const FrameView& view) {
    program.set("toLight", view.toLight);
    if (program.hasUniform("lightRadius"))
        program.set("lightRadius", view.lightRadius);
}

void drawObject(gl::Program& program, const SceneObject& object, const Camera& camera) {
    program.set("viewProjection", camera.viewProjection);
    program.set("eye", camera.eye);
    program.use();
    object.surface->draw();
}

}  // namespace

materials::SurfaceTextures& FrameRenderer::texturesOf(const SceneObject& object) {
    return object.textures ? *object.textures : noTextures_;
}

gl::Program& FrameRenderer::shadedProgram(const SceneObject& object, const FrameView& view) {
    if (!object.material)
        return programs_.get(kPlain, {}, {});
    std::vector<shaders::Define> defines = reliefDefines(object, view.camera);
    for (shaders::Define& define : texturesOf(object).defines(object.shading))
        defines.push_back(std::move(define));
    if (view.markExhausted)
        defines.push_back({"RELIEVO_MARK_EXHAUSTED", "1"});
    return programs_.get(kShaded, object.material->files(), defines);
}

void FrameRenderer::draw(std::span<const SceneObject> objects, const FrameView& view,
                         gl::Framebuffer& target) {
    prepare(target, view.camera.depth);
    target.clearColor(0, 0.09f, 0.09f, 0.1f, 1.0f);
    for (SceneObject object : objects) {
        const auto material = chosenMaterial(object, view.camera, target.width(), target.height());
        object.material = material ? &*material : nullptr;
        gl::Program& program = shadedProgram(object, view);
        setLight(program, view);
        if (object.material) {
            const GLuint unit = bindMaterial(program, object);
            texturesOf(object).bind(program, object.shading, unit);
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
        programs_.get(kMeasured, material->files(), reliefDefines(object, view.camera));
    prepare(target, view.camera.depth);
    // Misses are recorded as well: they are as far away as what the depth buffer was cleared to.
    glDepthFunc(fallsWithDistance(view.camera.depth) ? GL_GEQUAL : GL_LEQUAL);
    for (int attachment = 0; attachment < RELIEVO_OUTPUT_COUNT; ++attachment)
        target.clearColor(attachment, 0, 0, 0, 0);
    setLight(program, view);
    bindMaterial(program, object);
    drawObject(program, object, view.camera);
    return readMeasuredFrame(target);
}

}  // namespace relievo::viewer
