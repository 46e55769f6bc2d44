// A shadow map that is rendered through reliefs, against exact depths and exact visibility from the
// light.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "bench/scenes.h"
#include "depth_agreement.h"
#include "relief_scene.h"
#include "viewer/solid_stage.h"

namespace relievo::viewer {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;
constexpr int kMapSize = 512;

class ShadowMaps : public testing::Test {
  protected:
    ShadowMaps()
        : model_(bench::sceneModel("intersections")),
          scene_(model_, materials::findTechnique("exact"), 128),
          light_(orthographicCamera(model_.light, 1.0f)) {
        view_.camera = perspectiveCamera(model_.eye, static_cast<float>(kWidth) / kHeight);
    }

    struct ShadowErrors {
        std::size_t compared[2] = {0, 0};  // reliefs, meshes
        std::size_t shadowed = 0;
        std::size_t falselyLit = 0;
        double wrongShare[2] = {0.0, 0.0};
    };
    // Lookups in a map from `light` against what the model's light really reaches.
    ShadowErrors shadowErrors(const Camera& light, int mapSize) {
        const ShadowMap shadow = frames_.castShadows(scene_.objects(), light, mapSize);
        view_.shadowMap = &shadow;
        const VisibleFrame frame = frames_.show(scene_.objects(), view_, kWidth, kHeight);
        const auto objects = scene_.exactObjects();
        const auto hits = traceScene(objects, view_.camera, kWidth, kHeight);
        ShadowErrors errors;
        for (std::size_t k = 0; k < hits.size(); ++k) {
            if (!hits[k] || frame.pixels[k].object != static_cast<int>(hits[k]->object))
                continue;
            // What is turned away from the light is dark whatever the map says.
            if (glm::dot(hits[k]->normal, glm::dvec3(light_.eye)) <= 0.0)
                continue;
            const bool isLit = isVisible(objects, light_, hits[k]->position);
            const int kind = objects[hits[k]->object].relief ? 0 : 1;
            ++errors.compared[kind];
            errors.shadowed += !isLit;
            errors.wrongShare[kind] += isLit != frame.pixels[k].isLit;
            errors.falselyLit += !isLit && frame.pixels[k].isLit;
        }
        for (int kind = 0; kind < 2; ++kind)
            errors.wrongShare[kind] /= static_cast<double>(errors.compared[kind]);
        return errors;
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    bench::SceneModel model_;
    bench::StagedScene scene_;
    Camera light_;
    FrameRenderer frames_;
    FrameView view_;
};

TEST_F(ShadowMaps, HasTheExactDepths) {
    const auto depths = frames_.castShadows(scene_.objects(), light_, kMapSize).depths.readDepth();
    const auto exact = traceScene(scene_.exactObjects(), light_, kMapSize, kMapSize);
    const DepthAgreement agreement = compareDepths(depths, exact, light_);
    fmt::print("{} texels, {} beyond the bound, {} with and without a hit\n", agreement.compared,
               agreement.beyond, agreement.differing);
    EXPECT_GT(agreement.compared, 50000u);
    // Rays that graze a crest or the border of a window: floats decide which side they pass.
    EXPECT_LE(agreement.beyond + agreement.differing, agreement.compared / 2000);
    // The check sees a light that stands half a degree aside.
    bench::SceneModel moved = model_;
    moved.light.azimuth += 0.5f;
    const Camera aside = orthographicCamera(moved.light, 1.0f);
    EXPECT_GT(
        compareDepths(depths, traceScene(scene_.exactObjects(), aside, kMapSize, kMapSize), aside)
            .beyond,
        agreement.compared / 4);
}

TEST_F(ShadowMaps, ThrowsTheShadowsThatAreThere) {
    for (const int size : {512, 2048}) {
        const ShadowErrors errors = shadowErrors(light_, size);
        fmt::print(
            "{0}x{0}: {1} pixels in shadow, {6} of them lit; wrong {2:.3f} % of {3} on reliefs, "
            "{4:.3f} % of "
            "{5} on meshes\n",
            size, errors.shadowed, 100 * errors.wrongShare[0], errors.compared[0],
            100 * errors.wrongShare[1], errors.compared[1], errors.falselyLit);
        EXPECT_GT(errors.compared[0], 5000u);
        EXPECT_GT(errors.compared[1], 500u);
        EXPECT_GT(errors.shadowed, 1000u);
        // Along the borders of shadows, which the map has to a texel.
        EXPECT_LE(errors.wrongShare[0], size == 512 ? 0.016 : 0.0085);
        EXPECT_LE(errors.wrongShare[1], size == 512 ? 0.006 : 0.002);
    }
}

// The check sees shadows of a light that stands two degrees aside.
TEST_F(ShadowMaps, TheCheckCatchesShadowsOfAnotherLight) {
    bench::SceneModel moved = model_;
    moved.light.azimuth += 2.0f;
    EXPECT_GT(shadowErrors(orthographicCamera(moved.light, 1.0f), 2048).wrongShare[0], 0.012);
}

// Of a map that ends before the objects, and shows none.
TEST_F(ShadowMaps, LeaveLitWhatIsBehindAllOfThem) {
    OrbitCamera near = model_.light;
    near.target += 2.0f * glm::vec3(light_.eye);
    near.reach = 0.1f;
    const Camera light = orthographicCamera(near, 1.0f);
    const ShadowMap shadow = frames_.castShadows({}, light, 64);
    view_.shadowMap = &shadow;
    const VisibleFrame frame = frames_.show(scene_.objects(), view_, kWidth, kHeight);
    int seen = 0;
    for (const VisiblePixel& pixel : frame.pixels)
        if (pixel.object >= 0) {
            ++seen;
            EXPECT_TRUE(pixel.isLit);
        }
    EXPECT_GT(seen, 1000);
}

// All of a room and not much more, from above, from the side and from below.
TEST(LightCamera, HoldsTheRoomAsLargeAsItCan) {
    const surfaces::SurfaceExtent room{{-3.0f, 1.0f, 0.0f}, {5.0f, 2.5f, 0.5f}};
    for (const glm::vec2 light : {glm::vec2(20.0f, 40.0f), {-130.0f, 90.0f}, {70.0f, -5.0f}}) {
        const Camera camera = lightCamera(light, room);
        glm::vec3 low(2.0f);
        glm::vec3 high(-2.0f);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 place(corner & 1 ? room.maximum.x : room.minimum.x,
                                  corner & 2 ? room.maximum.y : room.minimum.y,
                                  corner & 4 ? room.maximum.z : room.minimum.z);
            const glm::vec4 seen = camera.viewProjection * glm::vec4(place, 1.0f);
            low = glm::min(low, glm::vec3(seen));
            high = glm::max(high, glm::vec3(seen));
        }
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(low[axis], -0.98f, 1e-5f);
            EXPECT_NEAR(high[axis], 0.98f, 1e-5f);
        }
        EXPECT_GT(low.z, -1.0f);
        EXPECT_LT(high.z, 1.0f);
    }
}

}  // namespace
}  // namespace relievo::viewer
