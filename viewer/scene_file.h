#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "outlines/outline.h"
#include "solids/solid.h"
#include "solids/solid_texturing.h"
#include "textures/wrap_mode.h"
#include "viewer/box_placement.h"
#include "viewer/camera.h"

namespace relievo::viewer {

/// Where the outline of a shape comes from.
enum class ShapeSource {
    Svg,   ///< a drawing
    Text,  ///< a line of text in a font
    Map,   ///< a shape map that is baked already
};

/// A plane shape of a scene.
struct SceneShape {
    ShapeSource source = ShapeSource::Svg;
    std::filesystem::path file;  ///< the drawing, the font or the map
    std::string text;            ///< of the source Text
    /// Texels of the map's width, from 1 to kLargestShape; its height follows the drawing's aspect.
    /// Of no meaning for the source Map, nor is the wrap mode, which the map says itself.
    int width = 512;
    textures::WrapMode wrap = textures::WrapMode::Clamp;
};

inline constexpr int kLargestShape = 8192;

/// A part of a box's solid.
struct ScenePart {
    std::string shape;       ///< its name among the scene's shapes
    solids::SolidPart part;  ///< all but the shape map, which is null
    PartPlace place;         ///< what part.fromWhole was made from
    /// Linear. Of all faces that are this part's surface, those that it cuts as a difference too.
    glm::vec3 colour{0.8f};
};

/// A relief on the walls and caps of a solid.
struct SceneRelief {
    std::filesystem::path map;        ///< a map file of relievo-bake relief
    std::string technique = "exact";  ///< of the registry, which is not asked here
    double depth = 0.05;              ///< its depth scale
    std::string place;                ///< `FILE: boxes[2].relief`, how errors about it begin
};

/// A shape box: a solid of up to solids::kMostParts parts, at one or more places.
struct SceneBox {
    std::string name;    ///< of its model, or "" for one that is written out in place
    glm::dvec3 size{1};  ///< edges S in world units
    std::vector<ScenePart> parts;
    solids::SolidTexturing texturing = solids::SolidTexturing::Box;
    std::filesystem::path picture;  ///< "" without one
    std::optional<SceneRelief> relief;
    glm::dvec2 pictureTiles{1};  ///< of the picture and the relief, in a tile of a part
    /// From the space of the whole (box_placement.h) to the world, of every copy.
    std::vector<glm::dmat4> wholeToWorld;
};

/// A rectangle around its own origin in the plane z = 0 that faces up.
struct SceneQuad {
    glm::dvec2 size{1};  ///< edges along x and y in world units
    glm::vec3 colour{0.8f};
    std::filesystem::path picture;
    std::vector<glm::dmat4> localToWorld;
};

/// The direction towards a light that is far away, in degrees as of viewer::OrbitCamera.
struct SceneLight {
    float azimuth = -50.0f;
    float elevation = 40.0f;

    friend bool operator==(const SceneLight&, const SceneLight&) = default;
};

/// A scene of shape boxes and plain meshes.
struct SceneFile {
    OrbitCamera camera;
    SceneLight light;
    std::map<std::string, SceneShape> shapes;
    std::vector<SceneBox> boxes;
    std::vector<SceneQuad> quads;
};

/// Copies of all boxes and quads together that a scene may have.
inline constexpr std::size_t kMostCopies = 100000;

/// Reads a scene in the format of docs/scenes.md. Paths in it are relative to its folder. The files
/// of shapes, pictures and reliefs are not opened.
///
/// Throws textures::InputError, `FILE: boxes[2].parts[0].kind: what is wrong, what was expected`,
/// for a file that cannot be read or is no JSON, for keys that are unknown, missing or twice, for
/// values of a wrong type or out of range, for names of shapes and models that are not there, for
/// profiles that solids::profileThrough refuses, and for too many parts or copies.
SceneFile readSceneFile(const std::filesystem::path& file);

/// The outlines of a shape as polylines that are within `tolerance` (tile widths, > 0) of them.
/// Throws textures::InputError when the file is not what it should be, and for the source Map.
outlines::Drawing readShapeDrawing(const SceneShape& shape, double tolerance);

/// Texels of the map's height for a drawing of that aspect: at least 1.
int shapeMapHeight(const SceneShape& shape, double aspect);

/// Shape maps by the names of a scene's shapes.
using ShapeMaps = std::map<std::string, std::shared_ptr<const textures::ShapeMap>>;

/// The solid of a box; `maps` has every shape of its parts.
solids::Compound compoundOf(const SceneBox& box, const ShapeMaps& maps);

}  // namespace relievo::viewer
