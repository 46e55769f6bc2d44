#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "materials/solid_material.h"
#include "materials/surface_textures.h"
#include "surfaces/surface_mesh.h"
#include "viewer/frame_renderer.h"
#include "viewer/scene_file.h"
#include "viewer/surface_buffers.h"
#include "viewer/view_options.h"

namespace relievo::viewer {

/// Reads a shape: a map file of the kind `shape`, or what relievo-bake shape would bake one from
/// (an SVG drawing, FONT:TEXT, a bitmap), baked in memory with `wrap` and `width` texels. Throws
/// textures::InputError.
std::shared_ptr<const textures::ShapeMap> openShape(
    const std::string& source, textures::WrapMode wrap = textures::WrapMode::Clamp,
    int width = 512);

/// Solids and plain meshes on the graphics processor, ready to be drawn. Needs a current context
/// for its whole life.
class SolidStage {
  public:
    explicit SolidStage(const materials::SolidTechnique& technique);

    /// Adds what a scene has; its shapes are baked on all cores. Throws textures::InputError.
    void add(const SceneFile& scene);
    /// Adds a solid in its box, or sunk into a mesh, and returns its material, which may be edited.
    materials::SolidMaterial& addBox(solids::Compound compound, const glm::dvec3& low,
                                     const glm::dvec3& high, const glm::dmat4& boxFromWhole,
                                     materials::TextureSet textures = {});
    materials::SolidMaterial& addSurface(solids::Compound compound,
                                         const surfaces::SurfaceMesh& mesh,
                                         materials::TextureSet textures = {});
    /// Adds a mesh of one colour (linear).
    void addPlain(const surfaces::SurfaceMesh& mesh, const glm::vec3& color,
                  materials::TextureSet textures = {});

    /// Puts the relief of a map file of relievo-bake relief on the walls and caps of a solid, shown
    /// by a technique of reliefs, with its usual depth scale. Solids with the same file share its
    /// maps. Throws textures::InputError.
    void putRelief(materials::SolidMaterial& solid, const std::filesystem::path& map,
                   std::string_view technique);

    /// Puts a solid of this stage into another mesh; low, high and boxFromWhole of its material are
    /// the caller's.
    void setSurface(const materials::SolidMaterial& solid, const surfaces::SurfaceMesh& mesh);

    /// Sets a parameter of the search for all solids that have it.
    void setParameter(std::string_view name, double value);

    /// These point into the stage.
    [[nodiscard]] std::vector<SceneObject> objects(const materials::Shading& shading);
    /// The room that the solids take.
    [[nodiscard]] surfaces::SurfaceExtent extent() const;
    [[nodiscard]] std::size_t solidCount() const noexcept { return solids_.size(); }

  private:
    struct Mesh {
        SurfaceBuffers surface;
        materials::SurfaceTextures textures;
        glm::vec3 color{0.6f};
        std::optional<materials::SolidMaterial> solid;
    };
    void addBoxes(const SceneBox& box, const ShapeMaps& shapes);
    void putRelief(materials::SolidMaterial& solid, const SceneRelief& relief);
    void addQuads(const SceneQuad& quad);

    const materials::SolidTechnique* technique_;
    std::shared_ptr<materials::ShapeTextureCache> shapes_;
    std::map<std::filesystem::path, std::shared_ptr<materials::ReliefMaps>> reliefs_;
    std::list<Mesh> meshes_;  // stay where they are
    std::vector<materials::SolidMaterial*> solids_;
};

/// The parallel projection of a far light that holds all of a room, for FrameRenderer::castShadows.
Camera lightCamera(const glm::vec2& light, const surfaces::SurfaceExtent& extent);

}  // namespace relievo::viewer
