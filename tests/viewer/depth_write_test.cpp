// The window depths that reliefs write, against those of the exact hits in double precision, in
// every kind of projection and depth range.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "depth_agreement.h"
#include "relief_scene.h"
#include "viewer/exact_scene.h"

namespace relievo::viewer {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;

struct Projection {
    bool isOrthographic;
    DepthConvention depth;
};

std::vector<Projection> everyProjection() {
    std::vector<Projection> result;
    for (const bool isOrthographic : {false, true})
        for (const bool zeroToOne : {false, true})
            for (const bool reversed : {false, true})
                for (const glm::vec2 range :
                     {glm::vec2(0, 1), glm::vec2(1, 0), glm::vec2(0.75f, 0.25f)})
                    result.push_back({isOrthographic, {zeroToOne, reversed, range}});
    return result;
}

std::string nameOf(const testing::TestParamInfo<Projection>& test) {
    const Projection& projection = test.param;
    const DepthConvention& depth = projection.depth;
    return fmt::format("{}_{}_{}_from_{}_to_{}",
                       projection.isOrthographic ? "orthographic" : "perspective",
                       depth.zeroToOne ? "0_1" : "minus1_1", depth.reversed ? "reversed" : "usual",
                       std::lround(100 * depth.range.x), std::lround(100 * depth.range.y));
}

Camera makeCamera(const Projection& projection) {
    OrbitCamera orbit;
    orbit.elevation = 30.0f;
    constexpr float kAspect = static_cast<float>(kWidth) / kHeight;
    return projection.isOrthographic ? orthographicCamera(orbit, kAspect, projection.depth)
                                     : perspectiveCamera(orbit, kAspect, projection.depth);
}

// A non-square relief, turned and skewed.
class DepthWrite : public testing::TestWithParam<Projection> {
  protected:
    DepthWrite()
        : map_(textures::generateSampleRelief("wave", 64, 32)),
          maps_(std::make_shared<materials::ReliefMaps>(bakeMaps(map_), "test")),
          material_(maps_, materials::findTechnique("exact")),
          mesh_(placed(surfaces::makeQuad({2, 3}, 0.5f), placement())),
          surface_(mesh_),
          target_(makeColorTarget(kWidth, kHeight)) {
        material_.depthScale = 0.2f;
        material_.pixelRays = 1;  // of several the nearest hit would count
        material_.window = {0, 0, 2, 3};
    }

    static glm::mat4 placement() {
        glm::mat4 skewed(1);
        skewed[1][0] = 0.3f;
        return glm::rotate(skewed, 0.4f, glm::vec3(0, 0.3f, 1));
    }
    std::vector<float> drawnDepths(const Camera& camera) {
        FrameView view;
        view.camera = camera;
        SceneObject object;
        object.surface = &surface_;
        object.material = &material_;
        frames_.draw({&object, 1}, view, target_);
        return target_.readDepth();
    }
    // What a program writes that was made for the depth buffer `made`.
    std::vector<float> depthsOfProgram(const Camera& camera, const DepthConvention& made) {
        drawnDepths(camera);  // sets up all but the program
        target_.clearDepth(fallsWithDistance(camera.depth) ? 0.0f : 1.0f);
        std::vector<shaders::Define> defines = material_.defines();
        if (made.zeroToOne)
            defines.push_back({"RELIEVO_CLIP_ZERO_TO_ONE", "1"});
        if (fallsWithDistance(made))
            defines.push_back({"RELIEVO_DEPTH_REVERSED", "1"});
        gl::Program& program =
            programs_.get("relievo/programs/measured.frag", material_.files(), defines);
        material_.bind(program.id());
        program.set("viewProjection", camera.viewProjection);
        program.set("eye", camera.eye);
        program.use();
        surface_.draw();
        return target_.readDepth();
    }
    std::vector<std::optional<ExactHit>> exactHits(const Camera& camera) const {
        const ExactObject object{&mesh_, &map_, static_cast<double>(material_.depthScale),
                                 glm::dvec4(material_.window)};
        return traceScene({&object, 1}, camera, kWidth, kHeight);
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    textures::DepthMap map_;
    std::shared_ptr<materials::ReliefMaps> maps_;
    materials::ReliefMaterial material_;
    surfaces::SurfaceMesh mesh_;
    SurfaceBuffers surface_;
    FrameRenderer frames_;
    materials::ProgramCache programs_;
    gl::Framebuffer target_;
};

TEST_P(DepthWrite, IsThatOfTheExactHit) {
    const Camera camera = makeCamera(GetParam());
    const auto hits = exactHits(camera);
    const std::vector<float> depths = drawnDepths(camera);
    const DepthAgreement agreement = compareDepths(depths, hits, camera);
    EXPECT_GT(agreement.compared, 800u);
    EXPECT_LE(agreement.worst, 1.0);
    // Rays through the very border of the surface or of its window.
    EXPECT_LE(agreement.differing, agreement.compared / 200);
}

// The check sees window depths made for another depth buffer.
TEST_P(DepthWrite, TheCheckCatchesAProgramForAnotherDepthBuffer) {
    const Camera camera = makeCamera(GetParam());
    const auto hits = exactHits(camera);
    for (const bool otherClip : {false, true}) {
        DepthConvention wrong = camera.depth;
        (otherClip ? wrong.zeroToOne : wrong.reversed) ^= true;
        const DepthAgreement agreement =
            compareDepths(depthsOfProgram(camera, wrong), hits, camera);
        EXPECT_TRUE(agreement.worst > 1000.0 || agreement.differing > agreement.compared / 2)
            << otherClip << ": " << agreement.worst;
    }
    EXPECT_LE(compareDepths(depthsOfProgram(camera, camera.depth), hits, camera).worst, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Projections, DepthWrite, testing::ValuesIn(everyProjection()), nameOf);

}  // namespace
}  // namespace relievo::viewer
