// Reliefs that pass through each other and through a mesh: each pixel shows what the exact rays
// meet first.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "bench/scenes.h"
#include "relief_scene.h"
#include "viewer/scene_errors.h"

namespace relievo::viewer {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

class Intersections : public testing::TestWithParam<std::tuple<bool, bool>> {
  protected:
    Intersections()
        : model_(bench::sceneModel("intersections")),
          scene_(model_, materials::findTechnique("exact"), 128) {
        const auto [isOrthographic, isReversed] = GetParam();
        const DepthConvention depth{isReversed, isReversed};
        constexpr float kAspect = static_cast<float>(kWidth) / kHeight;
        view_.camera = isOrthographic ? orthographicCamera(model_.eye, kAspect, depth)
                                      : perspectiveCamera(model_.eye, kAspect, depth);
    }
    SceneErrors errorsAgainst(std::span<const ExactObject> exact) {
        return compareScene(frames_.show(scene_.objects(), view_, kWidth, kHeight),
                            traceScene(exact, view_.camera, kWidth, kHeight), view_.camera);
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    bench::SceneModel model_;
    bench::StagedScene scene_;
    FrameRenderer frames_;
    FrameView view_;
};

TEST_P(Intersections, EachPixelShowsTheNearestObject) {
    const auto exact = scene_.exactObjects();
    std::vector<std::size_t> shown(exact.size());
    for (const auto& hit : traceScene(exact, view_.camera, kWidth, kHeight))
        if (hit)
            ++shown[hit->object];
    for (const std::size_t count : shown)
        EXPECT_GT(count, 500u);
    const SceneErrors errors = errorsAgainst(exact);
    fmt::print("{} pixels: another object {:.4f} %, wrong {:.4f} %, mean shift {:.2g} pixels\n",
               errors.pixels, 100 * errors.wrongObjectShare, 100 * errors.wrongShare,
               errors.meanShift);
    // Where two objects are equally far but for the rounding of floats.
    EXPECT_LE(errors.wrongObjectShare, 2e-4);
    EXPECT_LE(errors.wrongShare, 4e-4);
    EXPECT_LE(errors.meanShift, 1e-3);
}

// What would be seen if the depths were those of the coarse surfaces, or if one relief were a
// little deeper, is far from it.
TEST_P(Intersections, TheCheckCatchesOtherDepths) {
    auto flat = scene_.exactObjects();
    for (ExactObject& object : flat)
        object.relief = nullptr;
    EXPECT_GT(errorsAgainst(flat).wrongObjectShare, 0.05);
    auto deeper = scene_.exactObjects();
    deeper[0].depthScale *= 1.05;
    EXPECT_GT(errorsAgainst(deeper).wrongObjectShare, 0.003);
}

INSTANTIATE_TEST_SUITE_P(Projections, Intersections,
                         testing::Combine(testing::Bool(), testing::Bool()), [](const auto& test) {
                             return fmt::format(
                                 "{}_{}", std::get<0>(test.param) ? "orthographic" : "perspective",
                                 std::get<1>(test.param) ? "reversed" : "usual");
                         });

}  // namespace
}  // namespace relievo::viewer
