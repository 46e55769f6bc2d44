// What the window does with the options of shapes and scenes, without a window.
#include "viewer/solid_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "gl/context.h"
#include "tests/commands/process.h"
#include "tests/textures/temporary_folder.h"
#include "tests/viewer/map_fixture.h"
#include "tests/viewer/relief_scene.h"
#include "textures/input_error.h"
#include "textures/map_file.h"

namespace relievo::viewer {
namespace {

constexpr int kSide = 96;

constexpr std::string_view kDrawing = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 6">
  <path d="M1 1 H6 V3 H3 V5 H1 Z"/>
</svg>
)";

struct Edit {
    std::string name;
    std::function<void(ViewOptions&)> apply;
};

// Each is made on top of those before it; every one changes the picture.
const std::vector<Edit>& edits() {
    static const std::vector<Edit> all = {
        {"extension", [](ViewOptions& o) { o.solid.extension = 0.05; }},
        {"bevel", [](ViewOptions& o) { o.solid.bevel = 0.06; }},
        {"chamfer", [](ViewOptions& o) { o.solid.chamfer = 0.4; }},
        {"curve", [](ViewOptions& o) { o.solid.curve = solids::ProfileShape::Ogee; }},
        {"depth", [](ViewOptions& o) { o.depthScale = 0.25f; }},
        {"tiles",
         [](ViewOptions& o) {
             o.tiles = {2.0f, 1.5f};
         }},
        {"floor", [](ViewOptions& o) { o.solid.hasFloor = false; }},
        {"shadows", [](ViewOptions& o) { o.shadow = "search"; }},
        {"box", [](ViewOptions& o) { o.object = ObjectKind::Box; }},
        {"shape box", [](ViewOptions& o) { o.object = ObjectKind::ShapeBox; }},
        {"depth of the box", [](ViewOptions& o) { o.depthScale = 0.6f; }},
        {"size",
         [](ViewOptions& o) {
             o.solid.boxSize = {0.7f, 1.0f, 0.5f};
         }},
        {"tiles of the box",
         [](ViewOptions& o) {
             o.tiles = {1.0f, 1.0f};
         }},
        {"revolution", [](ViewOptions& o) { o.solid.kind = solids::SolidKind::Revolution; }},
        {"axis",
         [](ViewOptions& o) {
             o.solid.axis = {0.35, 0.6};
         }},
        {"depth tiles", [](ViewOptions& o) { o.solid.depthTiles = 3; }},
        {"undistorted", [](ViewOptions& o) { o.solid.boxSize = glm::vec3(0.0f); }},
        {"light",
         [](ViewOptions& o) {
             o.light = {60.0f, 20.0f};
         }},
        {"steps",
         [](ViewOptions& o) {
             o.parameters = {{"solid", "solid-steps", 2}};
         }},
        {"exhausted", [](ViewOptions& o) { o.markExhausted = true; }},
        {"no parameters", [](ViewOptions& o) { o.parameters.clear(); }},
        {"camera", [](ViewOptions& o) { o.camera.azimuth = 80.0f; }},
        {"sunk in", [](ViewOptions& o) { o.object = ObjectKind::Quad; }},
    };
    return all;
}

class SolidFrameTest : public testing::Test {
  protected:
    SolidFrameTest() {
        std::ofstream(folder_.file("ell.svg")) << kDrawing;
        options_.files = {folder_.file("ell.svg")};
        options_.techniques = {"solid"};
    }

    static bool isDrawnAgain(SolidFrame& frame, const ViewOptions& options, int height = kSide) {
        return frame.update(options, kSide, height) || frame.finish();
    }

    static std::vector<float> pictureOf(SolidFrame& frame, const ViewOptions& options) {
        isDrawnAgain(frame, options);
        EXPECT_FALSE(frame.progress());
        return frame.picture().read(0);
    }

    static std::vector<float> freshPicture(const ViewOptions& options) {
        SolidFrame frame(options);
        return pictureOf(frame, options);
    }

    // Of three objects; `box` is what else its boxes say.
    void openScene(const std::string& box = "") {
        std::ofstream(folder_.file("ell.json"))
            << R"({
            "shapes": {"ell": {"svg": "ell.svg", "size": 32}},
            "boxes": [{)"
            << box
            << R"("size": [1, 0.75, 0.5], "position": [-0.4, 0, 0.25], "rotation": [0, 0, 30],
                       "repeat": [{"count": 2, "step": [0.8, 0.3, 0]}],
                       "parts": [{"shape": "ell", "kind": "extrusion"}]}],
            "quads": [{"size": [2, 2]}]})";
        options_.files = {folder_.file("ell.json")};
    }

    // How often a window has to show the frame until the picture is finished.
    static int callsUntilFinished(SolidFrame& frame, const ViewOptions& options) {
        int calls = 1;
        while (!frame.update(options, kSide, kSide))
            ++calls;
        return calls;
    }

    tests::ScratchFolder folder_;
    std::unique_ptr<gl::Context> context_ = gl::createContext(gl::Backend::OSMesa);
    ViewOptions options_;
};

TEST_F(SolidFrameTest, AnEditedShapeIsTheOneThatWouldBeOpened) {
    SolidFrame frame(options_);
    std::vector<float> before = pictureOf(frame, options_);
    for (const Edit& edit : edits()) {
        SCOPED_TRACE(edit.name);
        edit.apply(options_);
        const std::vector<float> edited = pictureOf(frame, options_);
        EXPECT_EQ(frame.readings().problem, "");
        EXPECT_NE(edited, before);
        EXPECT_EQ(edited, freshPicture(options_));
        before = edited;
    }
    // And back again at once.
    const ViewOptions last = options_;
    for (const Edit& edit : edits()) {
        ViewOptions other = options_;
        edit.apply(other);
        pictureOf(frame, other);
    }
    EXPECT_EQ(pictureOf(frame, last), before);
}

TEST_F(SolidFrameTest, IsDrawnAgainOnlyForAReason) {
    SolidFrame frame(options_);
    EXPECT_TRUE(isDrawnAgain(frame, options_));
    EXPECT_FALSE(isDrawnAgain(frame, options_));
    EXPECT_TRUE(isDrawnAgain(frame, options_, kSide + 1));
    options_.solid.bevel = 0.1;
    EXPECT_TRUE(isDrawnAgain(frame, options_, kSide + 1));
    EXPECT_FALSE(isDrawnAgain(frame, options_, kSide + 1));
}

TEST_F(SolidFrameTest, WhatCannotBeShownIsSaidAndPassesOver) {
    SolidFrame frame(options_);
    const std::vector<float> good = pictureOf(frame, options_);
    ViewOptions flat = options_;
    flat.object = ObjectKind::ShapeBox;
    flat.depthScale = 0.0f;
    ViewOptions steps = options_;
    steps.parameters = {{"", "solid-steps", 0}};
    ViewOptions technique = options_;
    technique.techniques = {"none such"};
    for (const ViewOptions& bad : {flat, steps, technique}) {
        EXPECT_THROW(SolidFrame{bad}, textures::InputError);
        EXPECT_NE(pictureOf(frame, bad), good);
        EXPECT_NE(frame.readings().problem, "");
        EXPECT_FALSE(frame.update(bad, kSide, kSide)) << "tried again and again";
        frame.measure();
        EXPECT_FALSE(frame.readings().work);
        EXPECT_EQ(pictureOf(frame, options_), good);
        EXPECT_EQ(frame.readings().problem, "");
    }
}

TEST_F(SolidFrameTest, TheWorkOfAShapeIsCounted) {
    SolidFrame frame(options_);
    frame.update(options_, kSide, kSide);
    frame.measure();
    EXPECT_FALSE(frame.readings().work) << "of a picture that is not there yet";
    frame.finish();
    frame.measure();
    ASSERT_TRUE(frame.readings().work);
    EXPECT_GT(frame.readings().work->meanFetches, 0.0);
    EXPECT_EQ(frame.readings().work->exhausted, 0u);
    options_.parameters = {{"", "solid-steps", 1}};
    isDrawnAgain(frame, options_);
    frame.measure();
    EXPECT_GT(frame.readings().work->exhausted, 0u);
}

TEST_F(SolidFrameTest, AScenesShadowsFollowTheLight) {
    openScene();
    SolidFrame frame(options_);
    const std::vector<float> before = pictureOf(frame, options_);
    options_.light.x += 120.0f;
    const std::vector<float> after = pictureOf(frame, options_);
    EXPECT_NE(after, before);
    EXPECT_EQ(after, freshPicture(options_));
    options_.camera.azimuth += 20.0f;
    EXPECT_EQ(pictureOf(frame, options_), freshPicture(options_));
}

double difference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
        sum += std::abs(static_cast<double>(a[k]) - static_cast<double>(b[k]));
    return sum / static_cast<double>(a.size());
}

constexpr std::chrono::milliseconds kNoPatience{0};
constexpr int kObjects = 3;

TEST_F(SolidFrameTest, BoxesStandInUntilTheFirstPictureIsDrawnObjectByObject) {
    openScene();
    SolidFrame frame(options_, kNoPatience);
    EXPECT_FALSE(frame.update(options_, kSide, kSide));
    ASSERT_TRUE(frame.progress());
    EXPECT_TRUE(frame.progress()->isOfShadows);
    EXPECT_EQ(frame.progress()->done, 0u);
    EXPECT_EQ(frame.progress()->count, static_cast<std::size_t>(kObjects));
    const std::vector<float> standIns = frame.picture().read(0);
    EXPECT_FALSE(frame.update(options_, kSide, kSide));
    EXPECT_EQ(frame.progress()->done, 1u);
    EXPECT_EQ(frame.picture().read(0), standIns);
    while (frame.progress()->isOfShadows)
        EXPECT_FALSE(frame.update(options_, kSide, kSide));
    EXPECT_FALSE(frame.update(options_, kSide, kSide));
    EXPECT_EQ(frame.progress()->done, 1u);
    const std::vector<float> first = frame.picture().read(0);
    EXPECT_EQ(callsUntilFinished(frame, options_), kObjects - 1);
    const std::vector<float> finished = frame.picture().read(0);
    EXPECT_FALSE(frame.progress());

    SolidSession session(options_, materials::findSolidTechnique("solid"));
    gl::Framebuffer target(kSide, kSide, std::array<GLenum, 1>{GL_RGBA8});
    session.draw(options_, target);
    EXPECT_EQ(finished, target.read(0)) << "not what a run without a window writes";
    FrameRenderer::clear({}, target);
    EXPECT_LT(difference(standIns, finished), 0.5 * difference(target.read(0), finished));
    EXPECT_NE(first, standIns) << "the first object is there";
    EXPECT_LT(difference(first, finished), difference(standIns, finished));
}

TEST_F(SolidFrameTest, ADraftFollowsTheCamera) {
    openScene();
    SolidFrame frame(options_, kNoPatience);
    const std::vector<float> before = pictureOf(frame, options_);
    options_.camera.azimuth += 40.0f;
    EXPECT_FALSE(frame.update(options_, kSide, kSide));
    const std::vector<float> draft = frame.picture().read(0);
    EXPECT_EQ(callsUntilFinished(frame, options_), kObjects - 1) << "shadows are there already";
    const std::vector<float> after = frame.picture().read(0);
    EXPECT_EQ(after, freshPicture(options_));
    EXPECT_NE(draft, after);
    EXPECT_LT(difference(draft, after), 0.5 * difference(before, after));
}

TEST_F(SolidFrameTest, AnotherLightLeavesThePictureUntilItIsDrawn) {
    openScene();
    SolidFrame frame(options_, kNoPatience);
    const std::vector<float> before = pictureOf(frame, options_);
    options_.light.x += 120.0f;
    for (int call = 1; call < 2 * kObjects; ++call) {
        EXPECT_FALSE(frame.update(options_, kSide, kSide));
        EXPECT_EQ(frame.picture().read(0), before);
    }
    EXPECT_TRUE(frame.update(options_, kSide, kSide));
    EXPECT_EQ(frame.picture().read(0), freshPicture(options_));
}

TEST_F(SolidFrameTest, ShadowsGoOnWhileTheCameraMoves) {
    openScene();
    SolidFrame frame(options_, kNoPatience);
    frame.update(options_, kSide, kSide);
    frame.update(options_, kSide, kSide);
    options_.camera.azimuth += 40.0f;
    frame.update(options_, kSide, kSide);
    EXPECT_EQ(frame.progress()->done, 1u);
    EXPECT_EQ(pictureOf(frame, options_), freshPicture(options_));
}

TEST_F(SolidFrameTest, AScenesBoxesHaveReliefs) {
    tests::writeSampleMaps(folder_.file("noise.exr"), "noise", 32, 32);
    const auto picture = [&](const std::string& relief) {
        openScene(relief);
        return freshPicture(options_);
    };
    const auto bare = picture("");
    EXPECT_LT(difference(picture(R"("relief": {"map": "noise.exr", "depth": 0}, )"), bare), 1e-3);
    const auto deep = picture(R"("relief": {"map": "noise.exr", "depth": 0.2}, )");
    EXPECT_GT(difference(deep, bare), 5e-3);
    EXPECT_GT(difference(picture(R"("relief": {"map": "noise.exr", "depth": 0.2,
                                                "technique": "normal"}, )"),
                         deep),
              1e-3);
    EXPECT_GT(difference(picture(R"("relief": {"map": "noise.exr", "depth": 0.2},
                                    "pictureTiles": [3, 3], )"),
                         deep),
              1e-3);
}

// Deep below the wall, but nothing else: it can only be seen by shadows that it must not be in.
TEST_F(SolidFrameTest, AReliefIsInTheLightOfItsWall) {
    textures::DepthMap even;
    even.depth = textures::Plane(16, 16, 0.5f);
    textures::writeMapFile(folder_.file("even.exr"), bakeMaps(even),
                           textures::StorageFormat::Float);
    openScene();
    const std::vector<float> bare = freshPicture(options_);
    openScene(R"("relief": {"map": "even.exr", "depth": 0.5}, )");
    EXPECT_LT(difference(freshPicture(options_), bare), 1e-4);
}

TEST_F(SolidFrameTest, AReliefThatCannotBeShownIsSaidWithItsPlace) {
    tests::writeSampleMaps(folder_.file("flat.exr"), "noise", 8, 8, tests::ConeChannel::Missing);
    for (const auto& [relief, problem] : std::vector<std::pair<std::string, std::string>>{
             {R"({"map": "none.exr"})", "none.exr"},
             {R"({"map": "ell.svg"})", "ell.svg"},
             {R"({"map": "flat.exr", "technique": "cone"})", "cone"},
             {R"({"map": "flat.exr", "technique": "linea"})", "unknown technique \"linea\""}}) {
        openScene("\"relief\": " + relief + ", ");
        const std::string error = textures::errorOf([&] { SolidFrame{options_}; });
        EXPECT_THAT(error, testing::StartsWith(folder_.file("ell.json") + ": boxes[0].relief: "));
        EXPECT_THAT(error, testing::HasSubstr(problem));
    }
}

TEST(SolidPlace, SquareTexelsAndTilesOfAllKinds) {
    textures::ShapeMap shape;
    shape.distance = textures::Plane(8, 4);
    ViewOptions options;
    options.tiles = {2.0f, 3.0f};
    SolidPlace place = placeOf(options, shape);
    EXPECT_EQ(place.tiles, glm::dvec3(2, 3, 1));
    EXPECT_EQ(place.tileAspect, 0.5);
    options.object = ObjectKind::ShapeBox;
    options.depthScale = 0.5f;
    place = placeOf(options, shape);
    EXPECT_EQ(place.boxSize, glm::dvec3(1.0, 0.75, 0.25));
    options.solid.kind = solids::SolidKind::Revolution;
    options.solid.depthTiles = 8;
    place = placeOf(options, shape);
    EXPECT_EQ(place.tiles, glm::dvec3(2, 3, 8));
    EXPECT_EQ(place.boxSize, glm::dvec3(0.5, 0.75, 1.0));
    options.object = ObjectKind::Quad;
    EXPECT_EQ(placeOf(options, shape).tileAspect, 1.0) << "a section stands upright";
}

TEST(SolidPlace, ADrawingIsRepeatedInSeveralTilesOfAnExtrusion) {
    ViewOptions options;
    EXPECT_EQ(wrapModeFor(options), textures::WrapMode::Clamp);
    options.tiles = {1.0f, 1.5f};
    EXPECT_EQ(wrapModeFor(options), textures::WrapMode::Repeat);
    options.solid.kind = solids::SolidKind::Revolution;
    EXPECT_EQ(wrapModeFor(options), textures::WrapMode::Clamp);
}

}  // namespace
}  // namespace relievo::viewer
