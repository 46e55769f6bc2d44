#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "solids/solid.h"
#include "solids/solid_texturing.h"

namespace CLI {
class App;
}

namespace relievo::viewer {

/// What relievo-view makes of a shape: every number of a solid that can be edited.
struct SolidOptions {
    solids::SolidKind kind = solids::SolidKind::Extrusion;
    solids::ProfileShape curve = solids::ProfileShape::Bevel;
    double extension = 0.0;         ///< e, in tile widths
    double bevel = 0.0;             ///< b
    double chamfer = 1.0;           ///< c, in [0,1]
    std::vector<glm::dvec2> knots;  ///< (z, offset) of a profile instead of these; empty: none
    glm::dvec2 axis{0.5};           ///< O of a revolution
    int depthTiles = 1;             ///< replicas of a revolution along z
    glm::vec3 boxSize{0.0f};        ///< edges S of a shape box; 0: undistorted, the longest of 1
    bool hasFloor = true;           ///< of a solid sunk into a surface
    solids::SolidTexturing texturing = solids::SolidTexturing::Box;
    std::filesystem::path wallRelief;     ///< a relief on walls and caps; "" without one
    std::string wallTechnique = "exact";  ///< of the registry of reliefs; `normal`: a bump map
    float wallDepth = 0.05f;              ///< its depth scale
    glm::vec2 pictureTiles{1.0f};  ///< of pictures and that relief, in a tile of the texturing

    friend bool operator==(const SolidOptions&, const SolidOptions&) = default;
};

/// Adds the options for shapes to `app`; parsing fills `options`.
void addSolidOptions(CLI::App& app, SolidOptions& options);

/// The solid of one part that the options make of a shape, in `tiles` of u and v.
solids::Compound compoundOf(const SolidOptions& options,
                            const std::shared_ptr<const textures::ShapeMap>& shape,
                            const glm::vec2& tiles);

/// The edges of its box: those of the options, or undistorted ones (specification 7.4): with square
/// texels for an extrusion, whose depth is `depthScale` tile widths, and for the section of a
/// revolution; the longest edge is 1.
glm::dvec3 boxSizeOf(const SolidOptions& options, const textures::ShapeMap& shape,
                     const glm::vec2& tiles, double depthScale);

}  // namespace relievo::viewer
