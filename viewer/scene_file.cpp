#include "viewer/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <limits>
#include <optional>

#include "outlines/svg_outline.h"
#include "outlines/text_outline.h"
#include "textures/input_error.h"
#include "textures/srgb.h"
#include "viewer/checked_json.h"

namespace relievo::viewer {
namespace {

constexpr NumberRange kPlaces{-1e6, 1e6};   // world units
constexpr NumberRange kLengths{1e-6, 1e6};  // world units
constexpr NumberRange kDegrees{-360.0, 360.0};
constexpr NumberRange kTiles{1e-3, 1e3};
constexpr NumberRange kOffsets{-10.0, 10.0};  // tile widths
constexpr NumberRange kShares{0.0, 1.0};
constexpr NumberRange kReliefDepths{0.0, 1000.0};
constexpr int kMostRepeats = 3;
constexpr std::size_t kMost = 10000;  // boxes, quads

using Named = std::string_view;

constexpr std::array<std::pair<Named, textures::WrapMode>, 3> kWraps{
    {{"repeat", textures::WrapMode::Repeat},
     {"mirror", textures::WrapMode::Mirror},
     {"clamp", textures::WrapMode::Clamp}}};
constexpr std::array<std::pair<Named, solids::SolidKind>, 2> kKinds{
    {{"extrusion", solids::SolidKind::Extrusion}, {"revolution", solids::SolidKind::Revolution}}};
constexpr std::array<std::pair<Named, solids::BooleanOperation>, 3> kOperations{
    {{"union", solids::BooleanOperation::Union},
     {"intersection", solids::BooleanOperation::Intersection},
     {"difference", solids::BooleanOperation::Difference}}};
constexpr std::array<std::pair<Named, BoxAxis>, 3> kAxes{
    {{"x", BoxAxis::X}, {"y", BoxAxis::Y}, {"z", BoxAxis::Z}}};
constexpr std::array<std::pair<Named, solids::SolidTexturing>, 6> kTexturings{
    {{"planar-z", solids::SolidTexturing::PlanarZ},
     {"planar-y", solids::SolidTexturing::PlanarY},
     {"planar-diagonal", solids::SolidTexturing::PlanarDiagonal},
     {"cylindrical", solids::SolidTexturing::Cylindrical},
     {"spherical", solids::SolidTexturing::Spherical},
     {"box", solids::SolidTexturing::Box}}};

// What a box says of its looks, or its model, or a part; what comes first counts.
struct Looks {
    std::optional<glm::vec3> colour;
    std::optional<solids::SolidTexturing> texturing;
    std::filesystem::path picture;
    std::optional<SceneRelief> relief;
    std::optional<glm::dvec2> pictureTiles;
};

struct Reader {
    std::filesystem::path folder;
    SceneFile scene;
    std::map<std::string, CheckedJson> models;
    std::size_t copies = 0;

    [[nodiscard]] std::filesystem::path pathOf(const CheckedJson& json) const {
        return folder / json.text();
    }
};

double numberOr(const CheckedJson& json, std::string_view key, NumberRange range, double fallback) {
    const auto found = json.find(key);
    return found ? found->number(range) : fallback;
}

glm::dvec3 tripleOr(const CheckedJson& json, std::string_view key, NumberRange range,
                    const glm::dvec3& fallback) {
    const auto found = json.find(key);
    return found ? found->triple(range) : fallback;
}

template <typename Choices, typename Value>
Value choiceOr(const CheckedJson& json, std::string_view key, const Choices& choices,
               Value fallback) {
    const auto found = json.find(key);
    return found ? found->choice(choices) : fallback;
}

// "#c8b28a" in sRGB, or three linear numbers.
glm::vec3 readColour(const CheckedJson& json) {
    if (!json.isString())
        return json.triple(kShares);
    const std::string text = json.text();
    if (text.size() != 7 || text[0] != '#' ||
        text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
        json.fail(
            fmt::format("is \"{}\", expected a colour as \"#c8b28a\" or [0.6, 0.4, 0.2]", text));
    const auto channel = [&](std::size_t k) {
        const int byte = std::stoi(text.substr(1 + 2 * k, 2), nullptr, 16);
        return static_cast<float>(textures::linearFromSrgb(byte / 255.0));
    };
    return {channel(0), channel(1), channel(2)};
}

OrbitCamera readCamera(const CheckedJson& json) {
    json.expectKeys({"azimuth", "elevation", "distance", "fieldOfView", "target"});
    OrbitCamera camera;
    const auto number = [&](std::string_view key, NumberRange range, float& value) {
        value = static_cast<float>(numberOr(json, key, range, value));
    };
    number("azimuth", kDegrees, camera.azimuth);
    number("elevation", {-90.0, 90.0}, camera.elevation);
    number("distance", kLengths, camera.distance);
    number("fieldOfView", {1.0, 170.0}, camera.fieldOfView);
    camera.target = tripleOr(json, "target", kPlaces, camera.target);
    return camera;
}

SceneLight readLight(const CheckedJson& json) {
    json.expectKeys({"azimuth", "elevation"});
    SceneLight light;
    light.azimuth = static_cast<float>(numberOr(json, "azimuth", kDegrees, light.azimuth));
    light.elevation =
        static_cast<float>(numberOr(json, "elevation", {-90.0, 90.0}, light.elevation));
    return light;
}

SceneShape readShape(const Reader& reader, const CheckedJson& json) {
    SceneShape shape;
    if (json.has("map")) {
        json.expectKeys({"map"});
        shape.source = ShapeSource::Map;
        shape.file = reader.pathOf(json.at("map"));
        return shape;
    }
    if (json.has("text")) {
        json.expectKeys({"text", "font", "size", "wrap"});
        shape.source = ShapeSource::Text;
        shape.text = json.at("text").text();
        shape.file = reader.pathOf(json.at("font"));
    } else {
        json.expectKeys({"svg", "text", "map", "size", "wrap"});
        shape.file = reader.pathOf(json.at("svg"));
    }
    if (const auto size = json.find("size"))
        shape.width = size->integer(1, kLargestShape);
    shape.wrap = choiceOr(json, "wrap", kWraps, shape.wrap);
    return shape;
}

solids::Profile readProfile(const CheckedJson& json) {
    if (const auto knots = json.find("knots")) {
        json.expectKeys({"knots"});
        std::vector<glm::dvec2> points;
        for (const CheckedJson& knot : knots->elements(1, 2 * solids::kMostPieces))
            points.push_back(knot.pair(kOffsets));
        try {
            return solids::profileThrough(points);
        } catch (const textures::InputError& error) {
            knots->fail(error.what());
        }
    }
    json.expectKeys({"curve", "extension", "bevel", "chamfer", "knots"});
    solids::ProfileShape shape = solids::ProfileShape::Bevel;
    if (const auto name = json.find("curve")) {
        try {
            shape = solids::findProfileShape(name->text());
        } catch (const textures::InputError& error) {
            name->fail(error.what());
        }
    }
    return solids::makeProfile(numberOr(json, "extension", kOffsets, 0.0),
                               numberOr(json, "bevel", kOffsets, 0.0),
                               numberOr(json, "chamfer", kShares, 1.0), shape);
}

PartPlace readPlace(const CheckedJson& json, const glm::dvec3& size) {
    PartPlace place;
    place.minimum = tripleOr(json, "minimum", kPlaces, -0.5 * size);
    place.maximum = tripleOr(json, "maximum", kPlaces, 0.5 * size);
    const glm::dvec3 edges = place.maximum - place.minimum;
    if (std::min({edges.x, edges.y, edges.z}) < kLengths.least)
        json.fail("has a maximum that is not above its minimum, expected a place with three edges");
    place.along = choiceOr(json, "along", kAxes, place.along);
    place.tiles = tripleOr(json, "tiles", kTiles, place.tiles);
    return place;
}

void checkTiles(const CheckedJson& json, const SceneShape& shape, const ScenePart& part) {
    const glm::dvec3& tiles = part.place.tiles;
    if (part.part.solid.kind == solids::SolidKind::Revolution) {
        if (tiles != glm::floor(tiles))
            json.at("tiles").fail("has a part of a tile, expected whole tiles of a revolution");
        return;
    }
    if (tiles.z != 1.0)
        json.at("tiles").fail("repeats the depth, expected 1 as the third number of an extrusion");
    if (shape.source != ShapeSource::Map && shape.wrap == textures::WrapMode::Clamp &&
        std::max(tiles.x, tiles.y) > 1.0)
        json.at("tiles").fail(fmt::format(
            "repeats the shape \"{}\", expected the wrap repeat or mirror for it", part.shape));
}

void readRevolution(const CheckedJson& json, solids::Solid& solid) {
    json.expectKeys({"shape", "kind", "operation", "along", "minimum", "maximum", "tiles",
                     "extension", "axis", "colour"});
    solid.extension = numberOr(json, "extension", kOffsets, 0.0);
    if (const auto axis = json.find("axis"))
        solid.axis = axis->pair(kShares);
}

void readExtrusion(const CheckedJson& json, solids::Solid& solid) {
    json.expectKeys({"shape", "kind", "operation", "along", "minimum", "maximum", "tiles",
                     "profile", "colour"});
    if (const auto profile = json.find("profile"))
        solid.profile = readProfile(*profile);
}

ScenePart readPart(const Reader& reader, const CheckedJson& json, const glm::dvec3& size) {
    ScenePart part;
    solids::Solid& solid = part.part.solid;
    solid.kind = json.at("kind").choice(kKinds);
    if (solid.kind == solids::SolidKind::Revolution)
        readRevolution(json, solid);
    else
        readExtrusion(json, solid);
    part.shape = json.at("shape").text();
    const auto shape = reader.scene.shapes.find(part.shape);
    if (shape == reader.scene.shapes.end())
        json.at("shape").fail(
            fmt::format("is \"{}\", expected one of the scene's shapes", part.shape));
    part.part.operation = choiceOr(json, "operation", kOperations, part.part.operation);
    part.place = readPlace(json, size);
    part.part.windowMaximum = part.place.tiles;
    part.part.fromWhole = wholeToPart(size, part.place);
    checkTiles(json, shape->second, part);
    return part;
}

std::optional<glm::vec3> findColour(const CheckedJson& json) {
    const auto colour = json.find("colour");
    return colour ? std::optional(readColour(*colour)) : std::nullopt;
}

SceneRelief readRelief(const Reader& reader, const CheckedJson& json) {
    json.expectKeys({"map", "technique", "depth"});
    SceneRelief relief;
    relief.map = reader.pathOf(json.at("map"));
    if (const auto technique = json.find("technique"))
        relief.technique = technique->text();
    relief.depth = numberOr(json, "depth", kReliefDepths, relief.depth);
    relief.place = json.place();
    return relief;
}

// What `json` says, and the rest from `looks`.
Looks readLooks(const Reader& reader, const CheckedJson& json, Looks looks) {
    if (const auto colour = findColour(json))
        looks.colour = colour;
    if (const auto texturing = json.find("texturing"))
        looks.texturing = texturing->choice(kTexturings);
    if (const auto picture = json.find("picture"))
        looks.picture = reader.pathOf(*picture);
    if (const auto relief = json.find("relief"))
        looks.relief = readRelief(reader, *relief);
    if (const auto tiles = json.find("pictureTiles"))
        looks.pictureTiles = tiles->pair(kTiles);
    return looks;
}

std::vector<glm::dmat4> readCopies(Reader& reader, const CheckedJson& json) {
    std::vector<glm::dvec3> places = {tripleOr(json, "position", kPlaces, glm::dvec3(0.0))};
    if (const auto repeats = json.find("repeat"))
        for (const CheckedJson& repeat : repeats->elements(1, kMostRepeats)) {
            repeat.expectKeys({"count", "step"});
            const int count = repeat.at("count").integer(1, 1000);
            const glm::dvec3 step = repeat.at("step").triple(kPlaces);
            if (places.size() * static_cast<std::size_t>(count) > kMostCopies)
                repeats->fail(
                    fmt::format("makes more than {} copies, expected fewer", kMostCopies));
            std::vector<glm::dvec3> all;
            for (int k = 0; k < count; ++k)
                for (const glm::dvec3& place : places)
                    all.push_back(place + static_cast<double>(k) * step);
            places = std::move(all);
        }
    reader.copies += places.size();
    if (reader.copies > kMostCopies)
        json.fail(fmt::format("is beyond {} copies in all, expected fewer", kMostCopies));
    const glm::dvec3 degrees = tripleOr(json, "rotation", kDegrees, glm::dvec3(0.0));
    std::vector<glm::dmat4> copies;
    for (const glm::dvec3& place : places)
        copies.push_back(localToWorld(place, degrees));
    return copies;
}

// The size and the parts of a box or a model.
void readSolid(const Reader& reader, const CheckedJson& json, const Looks& looks, SceneBox& box) {
    box.size = json.at("size").triple(kLengths);
    for (const CheckedJson& element : json.at("parts").elements(1, solids::kMostParts)) {
        box.parts.push_back(readPart(reader, element, box.size));
        if (box.parts.size() == 1 && box.parts[0].part.operation != solids::BooleanOperation::Union)
            element.at("operation").fail("has nothing before it, expected union of a first part");
        const auto own = findColour(element);
        ScenePart& part = box.parts.back();
        part.colour = own ? *own : looks.colour.value_or(part.colour);
    }
    box.texturing = looks.texturing.value_or(box.texturing);
    box.picture = looks.picture;
    box.relief = looks.relief;
    box.pictureTiles = looks.pictureTiles.value_or(box.pictureTiles);
}

SceneBox readBox(Reader& reader, const CheckedJson& json) {
    SceneBox box;
    if (const auto name = json.find("model")) {
        json.expectKeys({"model", "position", "rotation", "repeat", "colour", "texturing",
                         "picture", "relief", "pictureTiles"});
        const auto model = reader.models.find(name->text());
        if (model == reader.models.end())
            name->fail(fmt::format("is \"{}\", expected one of the scene's models", name->text()));
        box.name = model->first;
        const CheckedJson& solid = model->second;
        readSolid(reader, solid, readLooks(reader, json, readLooks(reader, solid, {})), box);
    } else {
        json.expectKeys({"model", "size", "parts", "position", "rotation", "repeat", "colour",
                         "texturing", "picture", "relief", "pictureTiles"});
        readSolid(reader, json, readLooks(reader, json, {}), box);
    }
    for (const glm::dmat4& copy : readCopies(reader, json))
        box.wholeToWorld.push_back(copy * wholeToLocal(box.size));
    return box;
}

void readModel(Reader& reader, const std::string& name, const CheckedJson& json) {
    json.expectKeys({"size", "parts", "colour", "texturing", "picture", "relief", "pictureTiles"});
    SceneBox unused;  // a model is checked even when no box is of it
    readSolid(reader, json, readLooks(reader, json, {}), unused);
    reader.models.emplace(name, json);
}

SceneQuad readQuad(Reader& reader, const CheckedJson& json) {
    json.expectKeys({"size", "position", "rotation", "repeat", "colour", "picture"});
    SceneQuad quad;
    quad.size = json.at("size").pair(kLengths);
    quad.colour = findColour(json).value_or(quad.colour);
    if (const auto picture = json.find("picture"))
        quad.picture = reader.pathOf(*picture);
    quad.localToWorld = readCopies(reader, json);
    return quad;
}

}  // namespace

SceneFile readSceneFile(const std::filesystem::path& file) {
    const CheckedJson json = CheckedJson::readFile(file);
    json.expectKeys({"camera", "light", "shapes", "models", "boxes", "quads"});
    Reader reader{file.parent_path(), {}, {}, 0};
    if (const auto camera = json.find("camera"))
        reader.scene.camera = readCamera(*camera);
    if (const auto light = json.find("light"))
        reader.scene.light = readLight(*light);
    for (const auto& [name, shape] : json.at("shapes").members())
        reader.scene.shapes.emplace(name, readShape(reader, shape));
    if (const auto models = json.find("models"))
        for (const auto& [name, model] : models->members())
            readModel(reader, name, model);
    for (const CheckedJson& box : json.at("boxes").elements(1, kMost))
        reader.scene.boxes.push_back(readBox(reader, box));
    if (const auto quads = json.find("quads"))
        for (const CheckedJson& quad : quads->elements(0, kMost))
            reader.scene.quads.push_back(readQuad(reader, quad));
    return std::move(reader.scene);
}

outlines::Drawing readShapeDrawing(const SceneShape& shape, double tolerance) {
    switch (shape.source) {
        case ShapeSource::Svg:
            return outlines::readSvgDrawing(shape.file, tolerance);
        case ShapeSource::Text:
            return outlines::readTextDrawing(shape.file, shape.text, tolerance);
        case ShapeSource::Map:
            break;
    }
    throw textures::InputError(
        fmt::format("{}: is a baked map, which has no outline; a drawing or a font was expected",
                    shape.file.string()));
}

int shapeMapHeight(const SceneShape& shape, double aspect) {
    return std::max(1, static_cast<int>(std::lround(shape.width * aspect)));
}

solids::Compound compoundOf(const SceneBox& box, const ShapeMaps& maps) {
    solids::Compound compound;
    for (const ScenePart& part : box.parts) {
        compound.parts.push_back(part.part);
        compound.parts.back().solid.shape = maps.at(part.shape);
    }
    return compound;
}

}  // namespace relievo::viewer
