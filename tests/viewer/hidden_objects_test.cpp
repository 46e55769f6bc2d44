// Objects behind others are not searched, and the lookups of a frame are counted to the last one.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "bench/scenes.h"
#include "relief_scene.h"
#include "viewer/scene_errors.h"

namespace relievo::viewer {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

class HiddenObjects : public testing::Test {
  protected:
    HiddenObjects() : model_(bench::sceneModel("hidden")) {
        view_.camera = perspectiveCamera(model_.eye, static_cast<float>(kWidth) / kHeight);
    }
    bench::StagedScene stage(std::string_view technique) {
        return bench::StagedScene(model_, materials::findTechnique(technique), 64);
    }
    VisibleFrame show(std::span<const SceneObject> objects, bool skipHidden) {
        view_.skipHidden = skipHidden;
        return frames_.show(objects, view_, kWidth, kHeight);
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    bench::SceneModel model_;
    FrameRenderer frames_;
    FrameView view_;
};

// The sum over what each object takes alone: every fragment is searched, hidden or not.
TEST_F(HiddenObjects, EveryLookupOfTheFrameIsCounted) {
    const bench::StagedScene scene = stage("exact");
    std::uint64_t sum = 0;
    std::size_t pixels = 0;
    for (const SceneObject& object : scene.objects()) {
        // Front faces of one box or quad do not cover each other.
        for (const MeasuredPixel& pixel : frames_.measure(object, view_, kWidth, kHeight).pixels) {
            sum += static_cast<std::uint64_t>(pixel.covered ? pixel.fetches : 0);
            pixels += pixel.covered;
        }
    }
    const VisibleFrame frame = show(scene.objects(), false);
    EXPECT_EQ(frame.fetches, sum);
    EXPECT_GT(pixels, frame.pixels.size() * 3 / 4);
}

TEST_F(HiddenObjects, AreNotSearched) {
    const bench::StagedScene scene = stage("exact");
    const std::vector<SceneObject> all = scene.objects();
    const VisibleFrame plain = show(all, false);
    const VisibleFrame skipped = show(all, true);
    // The box is the first part, and behind the wall.
    const VisibleFrame withoutBox = show(std::span(all).subspan(1), false);
    EXPECT_EQ(skipped.fetches, withoutBox.fetches);
    EXPECT_LT(skipped.fetches, plain.fetches);
    for (std::size_t k = 0; k < plain.pixels.size(); ++k) {
        ASSERT_EQ(plain.pixels[k].object, skipped.pixels[k].object);
        ASSERT_EQ(plain.pixels[k].position, skipped.pixels[k].position);
    }
}

// One corner in sight is enough, in any depth convention: nothing that is seen may be left out.
TEST_F(HiddenObjects, WhatIsSeenAtAllIsDrawn) {
    bench::SceneModel peeping = model_;
    for (surfaces::SurfaceVertex& vertex : peeping.parts[0].mesh.vertices)
        vertex.position += glm::vec3(6, 0, 0);
    const bench::StagedScene scene(peeping, materials::findTechnique("exact"), 64);
    for (const bool isReversed : {false, true}) {
        view_.camera = perspectiveCamera(peeping.eye, static_cast<float>(kWidth) / kHeight,
                                         {isReversed, isReversed});
        const VisibleFrame frame = show(scene.objects(), true);
        const SceneErrors errors = compareScene(
            frame, traceScene(scene.exactObjects(), view_.camera, kWidth, kHeight), view_.camera);
        EXPECT_LE(errors.wrongObjectShare, 3e-4);
        EXPECT_GT(std::ranges::count(frame.pixels, 0, &VisiblePixel::object), 10);
    }
}

TEST_F(HiddenObjects, PicturesAreTheSame) {
    const bench::StagedScene scene = stage("auto");
    gl::Framebuffer target = makeColorTarget(kWidth, kHeight);
    frames_.draw(scene.objects(), view_, target);
    const std::vector<float> plain = target.read(0);
    view_.skipHidden = true;
    frames_.draw(scene.objects(), view_, target);
    EXPECT_EQ(target.read(0), plain);
}

}  // namespace
}  // namespace relievo::viewer
