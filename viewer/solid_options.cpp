#include "viewer/solid_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <string>

#include "textures/input_error.h"

namespace relievo::viewer {
namespace {

using solids::ProfileShape;
using solids::SolidKind;
using solids::SolidTexturing;

constexpr double kMostOffset = 10.0;  // tile widths
constexpr int kMostDepthTiles = 1000;

std::map<std::string, SolidTexturing> texturingNames() {
    std::map<std::string, SolidTexturing> names;
    for (int k = 0; k <= static_cast<int>(SolidTexturing::Box); ++k) {
        const auto texturing = static_cast<SolidTexturing>(k);
        names.emplace(solids::solidTexturingName(texturing), texturing);
    }
    return names;
}

std::map<std::string, ProfileShape> curveNames() {
    std::map<std::string, ProfileShape> names;
    for (const ProfileShape shape :
         {ProfileShape::Bevel, ProfileShape::Round, ProfileShape::Cove, ProfileShape::Ogee})
        names.emplace(solids::profileShapeName(shape), shape);
    return names;
}

// z,o,z,o,…
std::vector<glm::dvec2> knotsOf(const std::vector<double>& numbers) {
    if (numbers.size() % 2 != 0)
        throw CLI::ValidationError("--knots", "expected pairs of a depth and an offset");
    std::vector<glm::dvec2> knots;
    for (std::size_t k = 0; k < numbers.size(); k += 2)
        knots.emplace_back(numbers[k], numbers[k + 1]);
    try {
        static_cast<void>(solids::profileThrough(knots));
    } catch (const textures::InputError& error) {
        throw CLI::ValidationError("--knots", error.what());
    }
    return knots;
}

void addProfileOptions(CLI::App& app, SolidOptions& options) {
    const CLI::Range offsets(-kMostOffset, kMostOffset);
    app.add_option("--extension", options.extension,
                   "e: how far the solid reaches beyond its shape, in tile widths")
        ->check(offsets)
        ->capture_default_str()
        ->group("Shapes");
    app.add_option("--bevel", options.bevel,
                   "b: how much wider an extrusion is at the end of its bevel, in tile widths")
        ->check(offsets)
        ->capture_default_str()
        ->group("Shapes");
    app.add_option("--chamfer", options.chamfer,
                   "c: the share of the depth in which the bevel is done")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str()
        ->group("Shapes");
    app.add_option("--curve", options.curve, "The bevel's profile")
        ->transform(CLI::CheckedTransformer(curveNames()).description(""))
        ->type_name("bevel|round|cove|ogee")
        ->default_str("bevel")
        ->group("Shapes");
    app.add_option_function<std::vector<double>>(
           "--knots",
           [&options](const std::vector<double>& numbers) { options.knots = knotsOf(numbers); },
           "A profile of its own instead of these: depths from 0 to 1 with their offsets; two of "
           "one depth make a step")
        ->delimiter(',')
        ->type_name("Z,O,Z,O,...")
        ->group("Shapes");
}

void addWallOptions(CLI::App& app, SolidOptions& options) {
    app.add_option("--wall-relief", options.wallRelief,
                   "Map file of a relief on the walls and caps, where the picture lies")
        ->type_name("FILE")
        ->group("Shapes");
    app.add_option("--wall-technique", options.wallTechnique,
                   "How it is searched; see --list. normal makes it a bump map")
        ->type_name("NAME")
        ->capture_default_str()
        ->group("Shapes");
    app.add_option("--wall-depth", options.wallDepth, "Its depth scale")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str()
        ->group("Shapes");
    app.add_option_function<std::vector<float>>(
           "--picture-tiles",
           [&options](const std::vector<float>& tiles) {
               if (!(tiles[0] > 0.0f && tiles[1] > 0.0f))
                   throw CLI::ValidationError("--picture-tiles", "expected two numbers above 0");
               options.pictureTiles = {tiles[0], tiles[1]};
           },
           "Repetitions of --albedo and --wall-relief in a tile of the texturing")
        ->expected(2)
        ->delimiter(',')
        ->type_name("X,Y")
        ->default_str("1,1")
        ->group("Shapes");
}

}  // namespace

void addSolidOptions(CLI::App& app, SolidOptions& options) {
    app.add_option("--solid", options.kind, "What is made of a shape")
        ->transform(CLI::CheckedTransformer(
                        std::map<std::string, SolidKind>{{"extrusion", SolidKind::Extrusion},
                                                         {"revolution", SolidKind::Revolution}})
                        .description(""))
        ->type_name("extrusion|revolution")
        ->default_str("extrusion")
        ->group("Shapes");
    addProfileOptions(app, options);
    addWallOptions(app, options);
    app.add_option_function<std::vector<double>>(
           "--axis",
           [&options](const std::vector<double>& axis) {
               options.axis = {axis[0], axis[1]};
           },
           "Where the axis of a revolution stands in its tile")
        ->expected(2)
        ->delimiter(',')
        ->type_name("U,V")
        ->default_str("0.5,0.5")
        ->group("Shapes");
    app.add_option("--depth-tiles", options.depthTiles,
                   "Repetitions of a revolution along its axis")
        ->check(CLI::Range(1, kMostDepthTiles))
        ->capture_default_str()
        ->group("Shapes");
    app.add_option_function<std::vector<float>>(
           "--box-size",
           [&options](const std::vector<float>& size) {
               if (!std::ranges::all_of(size, [](float edge) { return edge > 0.0f; }))
                   throw CLI::ValidationError("--box-size", "expected three numbers above 0");
               options.boxSize = {size[0], size[1], size[2]};
           },
           "Edges of the shape box (--mesh shape-box); an elliptic solid has unequal ones")
        ->expected(3)
        ->delimiter(',')
        ->type_name("X,Y,Z")
        ->default_str("undistorted")
        ->group("Shapes");
    app.add_option("--texturing", options.texturing, "How --albedo is put on the solid")
        ->transform(CLI::CheckedTransformer(texturingNames()).description(""))
        ->type_name("planar-z|planar-y|planar-diagonal|cylindrical|spherical|box")
        ->default_str("box")
        ->group("Shapes");
    app.add_flag_function(
           "--see-through", [&options](std::int64_t) { options.hasFloor = false; },
           "A solid sunk into a surface has no floor around it")
        ->group("Shapes");
}

solids::Compound compoundOf(const SolidOptions& options,
                            const std::shared_ptr<const textures::ShapeMap>& shape,
                            const glm::vec2& tiles) {
    solids::SolidPart part;
    part.solid.shape = shape;
    part.solid.kind = options.kind;
    part.solid.axis = options.axis;
    part.windowMaximum = glm::dvec3(tiles, 1.0);
    if (options.kind == SolidKind::Revolution) {
        part.solid.extension = options.extension;
        part.windowMaximum.z = options.depthTiles;
    } else {
        part.solid.profile = options.knots.empty()
                                 ? solids::makeProfile(options.extension, options.bevel,
                                                       options.chamfer, options.curve)
                                 : solids::profileThrough(options.knots);
    }
    return {{part}};
}

glm::dvec3 boxSizeOf(const SolidOptions& options, const textures::ShapeMap& shape,
                     const glm::vec2& tiles, double depthScale) {
    if (options.boxSize.x > 0.0f)
        return options.boxSize;
    // In tile widths; the section of a revolution stands upright.
    glm::dvec3 size(tiles.x, shape.aspect() * static_cast<double>(tiles.y), depthScale);
    if (options.kind == SolidKind::Revolution)
        size = {tiles.x, tiles.y, shape.aspect() * options.depthTiles};
    return size / std::max({size.x, size.y, size.z});
}

}  // namespace relievo::viewer
