#include "viewer/frame_renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "gl/buffer.h"
#include "gl/occlusion_query.h"
#include "materials/detail_choice.h"
#include "shaders/relievo/constants.h"

namespace relievo::viewer {
namespace {

constexpr std::string_view kCoverage = "relievo/programs/coverage.frag";
constexpr std::string_view kVisible = "relievo/programs/visible.frag";

// The fragment shaders that differ between reliefs, solids and plain meshes.
struct FragmentFiles {
    std::string_view shaded;
    std::string_view measured;
    std::string_view depth;
};
constexpr FragmentFiles kReliefFiles{"relievo/programs/shaded.frag",
                                     "relievo/programs/measured.frag",
                                     "relievo/programs/depth.frag"};
constexpr FragmentFiles kSolidFiles{"relievo/programs/solid_shaded.frag",
                                    "relievo/programs/solid_measured.frag",
                                    "relievo/programs/solid_depth.frag"};
constexpr FragmentFiles kPlainFiles{"relievo/programs/plain.frag", "", kCoverage};

const FragmentFiles& fragmentFilesOf(const SceneObject& object) {
    return object.solid ? kSolidFiles : object.material ? kReliefFiles : kPlainFiles;
}

// Whether there is something to search.
bool isSearched(const SceneObject& object) {
    return object.material || object.solid;
}

void clearDepths(gl::Framebuffer& target, const DepthConvention& depth) {
    target.clearDepth(fallsWithDistance(depth) ? 0.0f : 1.0f);
}

// All that drawing needs of the context's state, so that others may use it between two objects.
void prepare(const gl::Framebuffer& target, const DepthConvention& depth) {
    const bool falls = fallsWithDistance(depth);
    target.bind();
    glClipControl(GL_LOWER_LEFT, depth.zeroToOne ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    glDepthRangef(depth.range.x, depth.range.y);
    glDepthFunc(falls ? GL_GREATER : GL_LESS);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

// What the programs of an object are made with: also what they must know of the depth buffer
// (relievo/trace.glsl).
std::vector<shaders::Define> definesFor(const SceneObject& object, const FrameView& view) {
    std::vector<shaders::Define> defines;
    if (object.solid)
        defines = object.solid->defines();
    else if (object.material)
        defines = object.material->defines();
    else
        defines.push_back({"RELIEVO_PLAIN", "1"});
    if (view.camera.depth.zeroToOne)
        defines.push_back({"RELIEVO_CLIP_ZERO_TO_ONE", "1"});
    if (fallsWithDistance(view.camera.depth))
        defines.push_back({"RELIEVO_DEPTH_REVERSED", "1"});
    if (view.shadowMap)
        defines.push_back({"RELIEVO_SHADOW_MAP", "1"});
    return defines;
}

// The files of the shader library for a program that shades, and for one that searches only.
std::vector<std::string_view> filesOf(const SceneObject& object) {
    if (object.solid)
        return object.solid->files();
    return object.material ? object.material->files() : std::vector<std::string_view>();
}
std::vector<std::string_view> searchFilesOf(const SceneObject& object) {
    if (object.solid)
        return object.solid->searchFiles();
    if (!object.material)
        return {};
    return {object.material->technique().file};
}

// Binds a texture to the first free unit and counts that up.
void bindTexture(gl::Program& program, std::string_view sampler, const gl::Texture& texture,
                 GLuint& unit) {
    program.set(sampler, static_cast<int>(unit));
    texture.bind(unit++);
}

// Each of these takes the first free texture unit and returns the first that stays free.
GLuint bindMaterial(gl::Program& program, const SceneObject& object) {
    if (object.solid)
        return object.solid->bind(program.id());
    GLuint unit = object.material->bind(program.id());
    if (object.givenHits)
        bindTexture(program, "relievoGivenHits", *object.givenHits, unit);
    if (object.givenVisibility)
        bindTexture(program, "relievoGivenVisibility", *object.givenVisibility, unit);
    return unit;
}

GLuint bindSearch(gl::Program& program, const SceneObject& object) {
    if (object.solid)
        return object.solid->bindSearch(program.id());
    return object.material ? object.material->bindSearch(program.id()) : 0;
}

GLuint bindShadowMap(gl::Program& program, const FrameView& view, GLuint unit) {
    if (view.shadowMap) {
        bindTexture(program, "shadowMap", view.shadowMap->depths.depth(), unit);
        program.set("shadowViewProjection", view.shadowMap->light.viewProjection);
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

void drawSurface(gl::Program& program, const SurfaceBuffers& surface, const Camera& camera) {
    program.set("viewProjection", camera.viewProjection);
    if (program.hasUniform("eye"))
        program.set("eye", camera.eye);
    program.use();
    surface.draw();
}

// Of a box the back faces are drawn, which are there wherever the eye is, also behind the far
// plane.
void drawObject(gl::Program& program, const SceneObject& object, const Camera& camera) {
    const bool isBox = object.solid && object.solid->isInBox();
    if (isBox) {
        glCullFace(GL_FRONT);
        glEnable(GL_DEPTH_CLAMP);
    }
    drawSurface(program, *object.surface, camera);
    if (isBox) {
        glCullFace(GL_BACK);
        glDisable(GL_DEPTH_CLAMP);
    }
}

// How near the box around a surface comes to the eye; to be compared with others of one camera.
float nearness(const surfaces::SurfaceExtent& extent, const glm::vec4& eye) {
    if (eye.w > 0.0f) {
        const glm::vec3 position(eye);
        const glm::vec3 nearest = glm::clamp(position, extent.minimum, extent.maximum);
        return -glm::distance(position, nearest);
    }
    const glm::vec3 direction(eye);
    return glm::dot(glm::max(direction * extent.minimum, direction * extent.maximum),
                    glm::vec3(1.0f));
}

// The numbers of the objects in the order in which they are drawn.
std::vector<int> drawingOrder(std::span<const SceneObject> objects, const FrameView& view) {
    std::vector<int> order(objects.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int number) {
        const SceneObject& object = objects[static_cast<std::size_t>(number)];
        return -nearness(object.surface->extent(), view.camera.eye);
    };
    if (view.skipHidden)
        std::ranges::stable_sort(order, {}, key);
    return order;
}

// Both halves of a counter on the graphics processor.
std::uint64_t readCounter(const gl::Buffer& counter) {
    std::array<std::uint32_t, 2> halves{};
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(counter.id(), 0, sizeof(halves), halves.data());
    return (std::uint64_t{halves[1]} << 32) + halves[0];
}

}  // namespace

materials::SurfaceTextures& FrameRenderer::texturesOf(const SceneObject& object) {
    return object.textures ? *object.textures : noTextures_;
}

gl::Program& FrameRenderer::program(std::string_view fragmentFile,
                                    const std::vector<std::string_view>& materialFiles,
                                    const SceneObject& object, const FrameView& view,
                                    std::vector<shaders::Define> more) {
    std::vector<shaders::Define> defines = definesFor(object, view);
    std::ranges::move(more, std::back_inserter(defines));
    return programs_.get(fragmentFile, materialFiles, defines);
}

void FrameRenderer::drawObjects(std::span<const SceneObject> objects, const FrameView& view,
                                const gl::Framebuffer& target, const ProgramFor& programFor) {
    for (const int number : drawingOrder(objects, view)) {
        SceneObject object = objects[static_cast<std::size_t>(number)];
        const auto material = chosenMaterial(object, view.camera, target.width(), target.height());
        object.material = material ? &*material : nullptr;
        const bool mayBeHidden = view.skipHidden && object.material;
        std::optional<gl::OcclusionQuery> query;
        if (mayBeHidden) {
            query.emplace();
            query->begin();
            drawCoverage(*object.surface, view.camera);
            gl::OcclusionQuery::end();
        }
        gl::Program& program = programFor(object, number);
        if (mayBeHidden)
            query->beginConditional();
        drawObject(program, object, view.camera);
        if (mayBeHidden)
            gl::OcclusionQuery::endConditional();
    }
}

// Draws nothing, but asks the depth test. Only a program that writes no depth itself gets its
// answer before it runs.
void FrameRenderer::drawCoverage(const SurfaceBuffers& surface, const Camera& camera) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    drawSurface(programs_.get(kCoverage, {}, {}), surface, camera);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
}

void FrameRenderer::draw(std::span<const SceneObject> objects, const FrameView& view,
                         gl::Framebuffer& target) {
    clear(view.camera, target);
    add(objects, view, target);
}

void FrameRenderer::clear(const Camera& camera, gl::Framebuffer& target) {
    clearDepths(target, camera.depth);
    target.clearColor(0, 0.09f, 0.09f, 0.1f, 1.0f);
}

void FrameRenderer::add(std::span<const SceneObject> objects, const FrameView& view,
                        const gl::Framebuffer& target) {
    prepare(target, view.camera.depth);
    drawObjects(objects, view, target, [&](const SceneObject& object, int) -> gl::Program& {
        std::vector<shaders::Define> defines = texturesOf(object).defines(object.shading);
        if (view.markExhausted)
            defines.push_back({"RELIEVO_MARK_EXHAUSTED", "1"});
        gl::Program& shaded = program(fragmentFilesOf(object).shaded, filesOf(object), object, view,
                                      std::move(defines));
        setLight(shaded, view);
        GLuint unit = 0;
        if (isSearched(object))
            unit = bindMaterial(shaded, object);
        else
            shaded.set("plainColor", object.plainColor);
        unit = texturesOf(object).bind(shaded, object.shading, unit);
        bindShadowMap(shaded, view, unit);
        return shaded;
    });
}

MeasuredFrame FrameRenderer::measure(SceneObject object, const FrameView& view, int width,
                                     int height) {
    gl::Framebuffer target = makeMeasuredTarget(width, height);
    clearDepths(target, view.camera.depth);
    prepare(target, view.camera.depth);
    // Misses are recorded as well: they are as far away as what the depth buffer was cleared to.
    glDepthFunc(fallsWithDistance(view.camera.depth) ? GL_GEQUAL : GL_LEQUAL);
    for (int attachment = 0; attachment < RELIEVO_OUTPUT_COUNT; ++attachment)
        target.clearColor(attachment, 0, 0, 0, 0);
    FrameView alone = view;
    alone.shadowMap = nullptr;
    alone.skipHidden = false;
    drawObjects({&object, 1}, alone, target, [&](const SceneObject& drawn, int) -> gl::Program& {
        // What is shaded on a solid does not change where it is.
        gl::Program& measured =
            program(fragmentFilesOf(drawn).measured,
                    drawn.solid ? searchFilesOf(drawn) : filesOf(drawn), drawn, alone);
        setLight(measured, alone);
        if (drawn.solid)
            bindSearch(measured, drawn);
        else
            bindMaterial(measured, drawn);
        return measured;
    });
    return readMeasuredFrame(target);
}

VisibleFrame FrameRenderer::show(std::span<const SceneObject> objects, const FrameView& view,
                                 int width, int height) {
    gl::Framebuffer target = makeVisibleTarget(width, height);
    clearDepths(target, view.camera.depth);
    prepare(target, view.camera.depth);
    target.clearColor(RELIEVO_VISIBLE_POINT, 0, 0, 0, 0);
    target.clearColor(RELIEVO_VISIBLE_LIGHT, 0, 0, 0, 0);
    constexpr std::array<std::uint32_t, 2> kZero{};
    const gl::Buffer counter(std::as_bytes(std::span(kZero)));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RELIEVO_BUFFER_LOOKUPS, counter.id());
    drawObjects(objects, view, target, [&](const SceneObject& object, int number) -> gl::Program& {
        gl::Program& visible = program(kVisible, searchFilesOf(object), object, view);
        visible.set("objectNumber", number);
        const GLuint unit = bindSearch(visible, object);
        bindShadowMap(visible, view, unit);
        return visible;
    });
    VisibleFrame frame = readVisibleFrame(target);
    frame.fetches = readCounter(counter);
    return frame;
}

ShadowMap FrameRenderer::castShadows(std::span<const SceneObject> objects, const Camera& light,
                                     int size) {
    ShadowMap shadow = emptyShadowMap(light, size);
    addShadows(objects, shadow);
    return shadow;
}

ShadowMap FrameRenderer::emptyShadowMap(const Camera& light, int size) {
    ShadowMap shadow{light, gl::Framebuffer(size, size, {})};
    clearDepths(shadow.depths, light.depth);
    return shadow;
}

void FrameRenderer::addShadows(std::span<const SceneObject> objects, const ShadowMap& shadow) {
    FrameView view;
    view.camera = shadow.light;
    prepare(shadow.depths, shadow.light.depth);
    drawObjects(objects, view, shadow.depths, [&](const SceneObject& object, int) -> gl::Program& {
        gl::Program& depth =
            program(fragmentFilesOf(object).depth, searchFilesOf(object), object, view);
        bindSearch(depth, object);
        return depth;
    });
}

}  // namespace relievo::viewer
