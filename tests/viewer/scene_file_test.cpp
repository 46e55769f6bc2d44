// Scene files: what is read, and what is refused with which sentence.
#include "viewer/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/textures/temporary_folder.h"

namespace relievo::viewer {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// Top, bottom and both offsets of all pieces.
std::vector<double> numbersOf(const solids::Profile& profile) {
    std::vector<double> numbers;
    for (const solids::ProfilePiece& piece : profile.pieces)
        numbers.insert(numbers.end(),
                       {piece.top, piece.bottom, piece.topOffset, piece.bottomOffset});
    return numbers;
}

class SceneFiles : public textures::TemporaryFolder {
  protected:
    SceneFile read(const std::string& text) {
        textures::writeBytes(file("scene.json"), text);
        return readSceneFile(file("scene.json"));
    }
    std::string errorIn(const std::string& text) {
        return textures::errorOf([&] { read(text); });
    }
    // A scene whose only box has these parts.
    static std::string withParts(const std::string& parts, const std::string& box = "") {
        return R"({"shapes": {"a": {"svg": "a.svg"}, "b": {"svg": "b.svg", "wrap": "repeat"}},
                   "boxes": [{"size": [2, 4, 6], )" +
               box + "\"parts\": [" + parts + "]}]}";
    }
    ScenePart partOf(const std::string& part) { return read(withParts(part)).boxes[0].parts[0]; }
    std::string errorOfPart(const std::string& part) { return errorIn(withParts(part)); }
};

const std::string kPart = R"({"shape": "a", "kind": "extrusion"})";

TEST_F(SceneFiles, HaveDefaults) {
    const SceneFile scene = read(SceneFiles::withParts(kPart));
    EXPECT_EQ(scene.camera, OrbitCamera{});
    EXPECT_EQ(scene.light, SceneLight{});
    EXPECT_TRUE(scene.quads.empty());
    EXPECT_EQ(scene.shapes.at("a").width, 512);
    EXPECT_EQ(scene.shapes.at("a").wrap, textures::WrapMode::Clamp);
    ASSERT_EQ(scene.boxes.size(), 1u);
    const SceneBox& box = scene.boxes[0];
    EXPECT_EQ(box.texturing, solids::SolidTexturing::Box);
    EXPECT_TRUE(box.picture.empty());
    EXPECT_FALSE(box.relief);
    EXPECT_EQ(box.pictureTiles, glm::dvec2(1.0));
    ASSERT_EQ(box.wholeToWorld.size(), 1u);
    EXPECT_EQ(box.wholeToWorld[0], wholeToLocal({2, 4, 6}));
    const solids::SolidPart& part = box.parts.at(0).part;
    EXPECT_EQ(numbersOf(part.solid.profile), numbersOf(solids::makeProfile(0.0)));
    EXPECT_EQ(part.operation, solids::BooleanOperation::Union);
    EXPECT_EQ(part.windowMaximum, glm::dvec3(1.0));
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            EXPECT_NEAR(part.fromWhole[c][r], c == r ? 1.0 : 0.0, 1e-15);
}

TEST_F(SceneFiles, HaveAllThatTheySay) {
    const SceneFile scene = read(R"(
// A comment.
{
  "camera": {"azimuth": 10, "elevation": -20, "distance": 3, "fieldOfView": 50, "target": [1, 2, 3]},
  "light": {"azimuth": 4, "elevation": 5},
  "shapes": {
    "drawn": {"svg": "shapes/a.svg", "size": 64, "wrap": "mirror"},
    "written": {"text": "Ω", "font": "/fonts/a.ttf", "size": 100},
    "baked": {"map": "a.exr"}
  },
  "models": {
    "m": {"size": [1, 1, 1], "texturing": "spherical", "colour": [0.1, 0.2, 0.3],
          "parts": [{"shape": "drawn", "kind": "extrusion"},
                    {"shape": "baked", "kind": "extrusion", "colour": "#ff0080"}]}
  },
  "boxes": [
    {"model": "m", "position": [1, 0, 0]},
    {"model": "m", "colour": "#ffffff", "texturing": "planar-diagonal", "picture": "wood.png"},
    {"size": [2, 2, 2], /* inside, too */ "position": [0, 0, 5], "rotation": [0, 0, 90],
     "repeat": [{"count": 2, "step": [10, 0, 0]}, {"count": 3, "step": [0, 0, 100]}],
     "parts": [
       {"shape": "drawn", "kind": "revolution", "extension": 0.25, "axis": [0.5, 0.25],
        "along": "x", "tiles": [2, 1, 3]},
       {"shape": "drawn", "kind": "extrusion", "operation": "intersection", "tiles": [1.5, 2, 1],
        "profile": {"curve": "ogee", "extension": 0.1, "bevel": -0.2, "chamfer": 0.5}},
       {"shape": "drawn", "kind": "extrusion", "operation": "difference",
        "minimum": [-3, -1, -1], "maximum": [3, 1, 0.5], "profile": {"knots": [[0, 0.1], [1, 0]]}}
     ]}
  ],
  "quads": [{"size": [3, 4], "colour": "#000000", "position": [0, 0, -1], "picture": "floor.png"}]
}
)");
    EXPECT_EQ(scene.camera, (OrbitCamera{10.0f, -20.0f, 3.0f, 50.0f, {1, 2, 3}}));
    EXPECT_EQ(scene.light, (SceneLight{4.0f, 5.0f}));
    const SceneShape& drawn = scene.shapes.at("drawn");
    EXPECT_EQ(drawn.file, folder() / "shapes/a.svg");
    EXPECT_EQ(drawn.width, 64);
    EXPECT_EQ(drawn.wrap, textures::WrapMode::Mirror);
    EXPECT_EQ(scene.shapes.at("written").source, ShapeSource::Text);
    EXPECT_EQ(scene.shapes.at("written").text, "Ω");
    EXPECT_EQ(scene.shapes.at("written").file, "/fonts/a.ttf");
    EXPECT_EQ(scene.shapes.at("baked").source, ShapeSource::Map);

    ASSERT_EQ(scene.boxes.size(), 3u);
    const SceneBox& model = scene.boxes[0];
    EXPECT_EQ(model.name, "m");
    EXPECT_EQ(model.texturing, solids::SolidTexturing::Spherical);
    EXPECT_EQ(model.parts[0].colour, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_FLOAT_EQ(model.parts[1].colour.r, 1.0f);
    EXPECT_FLOAT_EQ(model.parts[1].colour.g, 0.0f);
    EXPECT_NEAR(model.parts[1].colour.b, std::pow((128.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_EQ(glm::dvec3(model.wholeToWorld[0] * glm::dvec4(0.5, 0.5, 0.5, 1)),
              glm::dvec3(1, 0, 0));
    EXPECT_EQ(scene.boxes[1].texturing, solids::SolidTexturing::PlanarDiagonal);
    EXPECT_EQ(scene.boxes[1].picture, folder() / "wood.png");
    EXPECT_EQ(scene.boxes[1].parts[0].colour, glm::vec3(1.0f)) << "the box over its model";
    EXPECT_FLOAT_EQ(scene.boxes[1].parts[1].colour.g, 0.0f) << "the part over the box";

    const SceneBox& box = scene.boxes[2];
    ASSERT_EQ(box.wholeToWorld.size(), 6u);
    const glm::dvec3 last(box.wholeToWorld[5] * glm::dvec4(1.0, 0.5, 0.5, 1.0));
    EXPECT_NEAR(last.x, 10.0, 1e-12);
    EXPECT_NEAR(last.y, 1.0, 1e-12) << "the box's x turned to the world's y";
    EXPECT_NEAR(last.z, 205.0, 1e-12);
    const solids::SolidPart& turned = box.parts[0].part;
    EXPECT_EQ(turned.solid.kind, solids::SolidKind::Revolution);
    EXPECT_EQ(turned.solid.extension, 0.25);
    EXPECT_EQ(turned.solid.axis, glm::dvec2(0.5, 0.25));
    EXPECT_EQ(turned.windowMaximum, glm::dvec3(2, 1, 3));
    EXPECT_EQ(box.parts[1].part.operation, solids::BooleanOperation::Intersection);
    EXPECT_EQ(numbersOf(box.parts[1].part.solid.profile),
              numbersOf(solids::makeProfile(0.1, -0.2, 0.5, solids::ProfileShape::Ogee)));
    EXPECT_EQ(box.parts[2].part.operation, solids::BooleanOperation::Difference);
    EXPECT_EQ(box.parts[2].part.solid.profile.pieces.size(), 1u);
    // The middle of the place, which reaches out of the box, is the middle of the tile.
    const glm::dvec3 middle(box.parts[2].part.fromWhole * glm::inverse(wholeToLocal(box.size)) *
                            glm::dvec4(0, 0, -0.25, 1));
    EXPECT_NEAR(glm::length(middle - 0.5), 0.0, 1e-12);

    ASSERT_EQ(scene.quads.size(), 1u);
    EXPECT_EQ(scene.quads[0].size, glm::dvec2(3, 4));
    EXPECT_EQ(scene.quads[0].picture, folder() / "floor.png");
    EXPECT_EQ(scene.quads[0].localToWorld.size(), 1u);
}

TEST_F(SceneFiles, HaveReliefsOfBoxesOverThoseOfModels) {
    const SceneFile scene = read(R"({
  "shapes": {"a": {"svg": "a.svg"}},
  "models": {"m": {"size": [1, 1, 1], "relief": {"map": "maps/bricks.exr"}, "pictureTiles": [3, 2],
                   "parts": [{"shape": "a", "kind": "extrusion"}]}},
  "boxes": [{"model": "m"},
            {"model": "m", "relief": {"map": "/b.exr", "technique": "normal", "depth": 0.2}}]
})");
    const SceneRelief relief = scene.boxes[0].relief.value();
    EXPECT_EQ(relief.map, folder() / "maps/bricks.exr");
    EXPECT_EQ(relief.technique, "exact");
    EXPECT_EQ(relief.depth, 0.05);
    EXPECT_EQ(relief.place, file("scene.json").string() + ": models.m.relief");
    EXPECT_EQ(scene.boxes[0].pictureTiles, glm::dvec2(3, 2));
    const SceneRelief other = scene.boxes[1].relief.value();
    EXPECT_EQ(other.map, "/b.exr");
    EXPECT_EQ(other.technique, "normal");
    EXPECT_EQ(other.depth, 0.2);
    EXPECT_EQ(other.place, file("scene.json").string() + ": boxes[1].relief");
    EXPECT_EQ(scene.boxes[1].pictureTiles, glm::dvec2(3, 2)) << "the model's";
}

TEST_F(SceneFiles, MakeCompounds) {
    const SceneFile scene = read(withParts(kPart + R"(,{"shape": "b", "kind": "revolution"})"));
    const auto a = std::make_shared<const textures::ShapeMap>();
    const auto b = std::make_shared<const textures::ShapeMap>();
    const solids::Compound compound = compoundOf(scene.boxes[0], {{"a", a}, {"b", b}});
    ASSERT_EQ(compound.parts.size(), 2u);
    EXPECT_EQ(compound.parts[0].solid.shape, a);
    EXPECT_EQ(compound.parts[1].solid.shape, b);
    EXPECT_EQ(compound.parts[1].solid.kind, solids::SolidKind::Revolution);
}

TEST_F(SceneFiles, ThatCannotBeReadSaySo) {
    EXPECT_EQ(textures::errorOf([&] { readSceneFile(file("none.json")); }),
              file("none.json").string() + ": cannot be read");
    EXPECT_EQ(textures::errorOf([&] { readSceneFile(folder()); }),
              folder().string() + ": cannot be read");
    EXPECT_THAT(errorIn("{\"shapes\": }"), HasSubstr("scene.json: is no JSON at byte 12"));
    EXPECT_THAT(errorIn(""), HasSubstr("is no JSON"));
    EXPECT_THAT(errorIn("[1e999]"), HasSubstr("number that is too large"));
    EXPECT_THAT(errorIn("[]"), HasSubstr("scene.json: is [], expected an object"));
}

TEST_F(SceneFiles, ErrorsBeginWithTheFileAndThePlace) {
    EXPECT_EQ(errorOfPart(R"({"shape": "a", "kind": "extruded"})"),
              file("scene.json").string() +
                  ": boxes[0].parts[0].kind: there is no \"extruded\", expected extrusion, "
                  "revolution");
}

struct Refused {
    std::string text;
    std::string error;
};

TEST_F(SceneFiles, RefuseKeysThatAreUnknownMissingOrTwice) {
    for (
        const Refused& refused : std::vector<Refused>{
            {R"({"shapes": {}, "boxs": []})", "has the key \"boxs\", expected camera, light"},
            {R"({"shapes": {}})", "has no \"boxes\", expected one"},
            {R"({"shapes": {}, "shapes": {}})", "the key \"shapes\" stands twice"},
            {R"({"shapes": {"a": {"svg": "a", "widht": 3}}, "boxes": []})",
             "shapes.a: has the key \"widht\""},
            {R"({"shapes": {"a": {"text": "a"}}, "boxes": []})", "shapes.a: has no \"font\""},
            {R"({"shapes": {"a": {"map": "a", "wrap": "clamp"}}, "boxes": []})",
             "shapes.a: has the key \"wrap\""},
            {R"({"shapes": {"a": {}}, "boxes": []})", "shapes.a: has no \"svg\""},
            {R"({"camera": {"roll": 3}, "shapes": {}, "boxes": []})", "camera: has the key"},
            {R"({"light": {"distance": 3}, "shapes": {}, "boxes": []})", "light: has the key"},
            {withParts(kPart, "\"posiion\": [0, 0, 0], "), "boxes[0]: has the key \"posiion\""},
            {withParts(kPart, R"("relief": {"depth": 1}, )"), "boxes[0].relief: has no \"map\""},
            {withParts(kPart, R"("relief": {"map": "a.exr", "scale": 1}, )"),
             "boxes[0].relief: has the key \"scale\", expected map, technique, depth"},
            {withParts(R"({"shape": "a", "kind": "extrusion", "relief": {"map": "a.exr"}})"),
             "boxes[0].parts[0]: has the key \"relief\""},
            {withParts(R"({"kind": "extrusion"})"), "boxes[0].parts[0]: has no \"shape\""},
            {withParts(R"({"shape": "a"})"), "boxes[0].parts[0]: has no \"kind\""},
            {withParts(R"({"shape": "a", "kind": "extrusion", "extension": 1})"),
             "has the key \"extension\""},
            {withParts(R"({"shape": "a", "kind": "revolution", "profile": {}})"),
             "has the key \"profile\""},
            {withParts(R"({"shape": "a", "kind": "extrusion", "profile": {"bevle": 1}})"),
             "parts[0].profile: has the key \"bevle\""},
            {withParts(
                 R"({"shape": "a", "kind": "extrusion", "profile": {"knots": [[0, 0]], "bevel": 1}})"),
             "parts[0].profile: has the key \"bevel\""},
            {withParts(kPart, R"("repeat": [{"count": 2, "stride": [0, 0, 1]}], )"),
             "boxes[0].repeat[0]: has the key \"stride\""},
            {R"({"shapes": {"a": {"svg": "a"}}, "models": {"m": {"size": [1, 1, 1],
                  "parts": [{"shape": "a", "kind": "extrusion"}], "position": [0, 0, 0]}}, "boxes": []})",
             "models.m: has the key \"position\""},
            {R"({"shapes": {"a": {"svg": "a"}}, "boxes": [
                  {"size": [1, 1, 1], "parts": [{"shape": "a", "kind": "extrusion"}]}],
                  "quads": [{"size": [1, 1], "depth": 1}]})",
             "quads[0]: has the key \"depth\""}})
        EXPECT_THAT(errorIn(refused.text), HasSubstr(refused.error));
}

TEST_F(SceneFiles, RefuseValuesOfAWrongTypeOrSize) {
    for (const Refused& refused : std::vector<Refused>{
             {R"({"shapes": {"a": {"svg": 3}}, "boxes": []})",
              "shapes.a.svg: is 3, expected a string"},
             {R"({"shapes": {"a": {"svg": ""}}, "boxes": []})", "is \"\", expected a string"},
             {R"({"shapes": {"a": {"svg": "a", "size": 0}}, "boxes": []})",
              "shapes.a.size: is 0, expected a whole number from 1 to 8192"},
             {R"({"shapes": {"a": {"svg": "a", "size": 8193}}, "boxes": []})", "is 8193"},
             {R"({"shapes": {"a": {"svg": "a", "size": 12.5}}, "boxes": []})", "is 12.5"},
             {R"({"shapes": {"a": {"svg": "a", "wrap": "tile"}}, "boxes": []})",
              "there is no \"tile\", expected repeat, mirror, clamp"},
             {R"({"camera": {"elevation": 91}, "shapes": {}, "boxes": []})",
              "camera.elevation: is 91, expected a number from -90 to 90"},
             {R"({"camera": {"distance": -1}, "shapes": {}, "boxes": []})", "camera.distance"},
             {R"({"shapes": {}, "boxes": []})", "boxes: is [], expected an array of 1 to 10000"},
             {R"({"shapes": {"a": {"svg": "a"}}, "boxes": [
                  {"size": [1, 0, 1], "parts": [{"shape": "a", "kind": "extrusion"}]}]})",
              "boxes[0].size[1]: is 0, expected a number from 1e-06"},
             {withParts(kPart, R"("position": [0, 0], )"),
              "boxes[0].position: is [0,0], expected an array of 3"},
             {withParts(kPart, R"("rotation": [0, 0, "90"], )"),
              "boxes[0].rotation[2]: is \"90\", expected a number"},
             {withParts(kPart, R"("colour": "red", )"), "boxes[0].colour: is \"red\", expected"},
             {withParts(kPart, R"("colour": "#12345g", )"), "is \"#12345g\", expected"},
             {withParts(kPart, R"("colour": [1, 2, 0], )"), "boxes[0].colour[1]: is 2"},
             {withParts(kPart, R"("texturing": "planar-x", )"),
              "there is no \"planar-x\", expected planar-z, planar-y"},
             {withParts(kPart, R"("relief": "a.exr", )"),
              "boxes[0].relief: is \"a.exr\", expected an object"},
             {withParts(kPart, R"("relief": {"map": ""}, )"), "boxes[0].relief.map: is \"\""},
             {withParts(kPart, R"("relief": {"map": "a.exr", "technique": 1}, )"),
              "boxes[0].relief.technique: is 1, expected a string"},
             {withParts(kPart, R"("relief": {"map": "a.exr", "depth": -1}, )"),
              "boxes[0].relief.depth: is -1, expected a number from 0 to 1000"},
             {withParts(kPart, R"("pictureTiles": [1, 0], )"), "boxes[0].pictureTiles[1]: is 0"},
             {withParts(kPart, R"("repeat": [{"count": 0, "step": [0, 0, 1]}], )"),
              "boxes[0].repeat[0].count: is 0"},
             {withParts(""), "boxes[0].parts: is [], expected an array of 1 to 4"},
             {withParts(kPart + "," + kPart + "," + kPart + "," + kPart + "," + kPart),
              "expected an array of 1 to 4"}})
        EXPECT_THAT(errorIn(refused.text), HasSubstr(refused.error));
}

TEST_F(SceneFiles, RefusePartsThatMakeNoSolid) {
    const auto part = [](const std::string& more, const std::string& kind = "extrusion") {
        return R"({"shape": "a", "kind": ")" + kind + "\", " + more + "}";
    };
    for (const Refused& refused : std::vector<Refused>{
             {R"({"shape": "c", "kind": "extrusion"})",
              "parts[0].shape: is \"c\", expected one of the scene's shapes"},
             {part(R"("operation": "difference")"),
              "parts[0].operation: has nothing before it, expected union"},
             {part(R"("operation": "minus")"), "expected union, intersection, difference"},
             {part(R"("along": "w")"), "there is no \"w\", expected x, y, z"},
             {part(R"("minimum": [0, 0, 0], "maximum": [1, 1, 0])"),
              "parts[0]: has a maximum that is not above its minimum"},
             {part(R"("tiles": [2, 1, 1])"),
              "parts[0].tiles: repeats the shape \"a\", expected the wrap repeat or mirror"},
             {part(R"("tiles": [1, 1, 2])"), "parts[0].tiles: repeats the depth"},
             {part(R"("tiles": [1, 1, 1.5])", "revolution"), "expected whole tiles"},
             {part(R"("tiles": [1, 0, 1])"), "parts[0].tiles[1]: is 0"},
             {part(R"("axis": [2, 0])", "revolution"), "parts[0].axis[0]: is 2"},
             {part(R"("profile": {"chamfer": 1.5})"), "parts[0].profile.chamfer: is 1.5"},
             {part(R"("profile": {"curve": "steps"})"),
              "parts[0].profile.curve: there is no profile \"steps\", expected bevel, round"},
             {part(R"("profile": {"knots": []})"), "parts[0].profile.knots: is []"},
             {part(R"("profile": {"knots": [[0.5, 0], [0.2, 0]]})"),
              "parts[0].profile.knots: the profile's knot (0.2, 0): expected depths"}})
        EXPECT_THAT(errorOfPart(refused.text), HasSubstr(refused.error));
}

TEST_F(SceneFiles, RefuseModelsThatAreNotThereAndTooManyCopies) {
    EXPECT_THAT(errorIn(R"({"shapes": {}, "boxes": [{"model": "m"}]})"),
                HasSubstr("boxes[0].model: is \"m\", expected one of the scene's models"));
    EXPECT_THAT(errorIn(R"({"shapes": {}, "boxes": [{"model": "m", "size": [1, 1, 1]}]})"),
                HasSubstr("boxes[0]: has the key \"size\""));
    const std::string many = R"({"count": 1000, "step": [1, 0, 0]})";
    EXPECT_THAT(errorIn(withParts(kPart, "\"repeat\": [" + many + "," + many + "], ")),
                HasSubstr("boxes[0].repeat: makes more than 100000 copies"));
    EXPECT_THAT(errorIn(withParts(
                    kPart, "\"repeat\": [" + many + "," + many + "," + many + "," + many + "], ")),
                HasSubstr("expected an array of 1 to 3"));
}

TEST_F(SceneFiles, DrawingsAreReadFromTheirSource) {
    textures::writeBytes(file("a.svg"),
                         "<svg viewBox='0 0 10 25'><rect width='5' height='5'/></svg>");
    SceneShape shape;
    shape.file = file("a.svg");
    EXPECT_DOUBLE_EQ(readShapeDrawing(shape, 0.01).aspect, 2.5);
    EXPECT_EQ(shapeMapHeight(shape, 2.5), 1280);
    EXPECT_EQ(shapeMapHeight(shape, 1e-9), 1);
    shape.source = ShapeSource::Text;
    EXPECT_THAT(textures::errorOf([&] { readShapeDrawing(shape, 0.01); }), HasSubstr("a.svg"));
    shape.source = ShapeSource::Map;
    EXPECT_THAT(textures::errorOf([&] { readShapeDrawing(shape, 0.01); }),
                HasSubstr("has no outline"));
}

}  // namespace
}  // namespace relievo::viewer
