#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "materials/program_cache.h"
#include "materials/relief_material.h"
#include "materials/solid_material.h"
#include "materials/surface_textures.h"
#include "viewer/camera.h"
#include "viewer/measured_frame.h"
#include "viewer/surface_buffers.h"
#include "viewer/visible_frame.h"

namespace relievo::viewer {

/// One object of a frame: a surface in the world, and what it is made of. What it points at must be
/// there while the frame is drawn.
struct SceneObject {
    const SurfaceBuffers* surface = nullptr;
    /// The relief with its technique, depth scale and window; null for a solid and a plain mesh.
    const materials::ReliefMaterial* material = nullptr;
    /// The solid that is sunk into the surface, or in the box that the surface is; null: none.
    const materials::SolidMaterial* solid = nullptr;
    /// The texture set; null for plain grey.
    materials::SurfaceTextures* textures = nullptr;
    materials::Shading shading;
    glm::vec3 plainColor{0.6f};  ///< linear; of a plain mesh, times its albedo
    /// The hits of a material of materials::givenHitsTechnique().
    const gl::Texture* givenHits = nullptr;
    /// The shares of the light for a material with materials::givenShadowMethod().
    const gl::Texture* givenVisibility = nullptr;
};

/// What a light that is far away sees of a scene.
struct ShadowMap {
    Camera light;            ///< a parallel projection with the usual depth convention
    gl::Framebuffer depths;  ///< without colours
};

/// What a frame shows, apart from the objects in it.
struct FrameView {
    Camera camera;
    glm::vec3 toLight{0, 0, 1};  ///< unit vector
    float lightRadius = 0.0f;    ///< what the light spans to each side, in radians
    int lightRays = 0;           ///< of the exact picture's shadows; 0: it has none
    bool markExhausted = false;  ///< paint searches that ran out of steps magenta, not as holes
    const ShadowMap* shadowMap = nullptr;  ///< of the light; null: nothing throws a shadow
    /// Draw the nearest objects first, and do not search those whose surface is hidden by what has
    /// been drawn: a relief lies behind its surface. The picture is the same.
    bool skipHidden = false;
};

/// Draws frames of objects, whose depths decide between them pixel by pixel. It draws to
/// framebuffer objects only. Needs a current context for its whole life.
class FrameRenderer {
  public:
    /// Draws the shaded objects over a background of (0.09, 0.09, 0.1) into attachment 0 of
    /// `target`.
    void draw(std::span<const SceneObject> objects, const FrameView& view, gl::Framebuffer& target);
    /// The same in pieces, between which the context may be used for other things: clear() and then
    /// add() for all objects, some at a time. What skipHidden hides is up to the pieces.
    static void clear(const Camera& camera, gl::Framebuffer& target);
    void add(std::span<const SceneObject> objects, const FrameView& view,
             const gl::Framebuffer& target);
    /// Records the searches of every pixel of one object, which has a relief or is a solid.
    MeasuredFrame measure(SceneObject object, const FrameView& view, int width, int height);
    /// Records what every pixel shows, and counts the lookups of the whole frame.
    VisibleFrame show(std::span<const SceneObject> objects, const FrameView& view, int width,
                      int height);
    /// The depths that `light` (a parallel projection) sees, size² texels.
    ShadowMap castShadows(std::span<const SceneObject> objects, const Camera& light, int size);
    /// The same in pieces: nothing throws a shadow until addShadows() has been called for it.
    static ShadowMap emptyShadowMap(const Camera& light, int size);
    void addShadows(std::span<const SceneObject> objects, const ShadowMap& shadow);

  private:
    /// Finds the program for an object, whose number is the second argument, and sets what is not
    /// the camera's.
    using ProgramFor = std::function<gl::Program&(const SceneObject&, int)>;

    void drawObjects(std::span<const SceneObject> objects, const FrameView& view,
                     const gl::Framebuffer& target, const ProgramFor& programFor);
    void drawCoverage(const SurfaceBuffers& surface, const Camera& camera);
    /// The program of a fragment shader for an object of the frame.
    gl::Program& program(std::string_view fragmentFile,
                         const std::vector<std::string_view>& materialFiles,
                         const SceneObject& object, const FrameView& view,
                         std::vector<shaders::Define> more = {});
    /// The object's texture set, or the empty one.
    materials::SurfaceTextures& texturesOf(const SceneObject& object);

    materials::ProgramCache programs_;
    materials::SurfaceTextures noTextures_;
};

}  // namespace relievo::viewer
