// The window depths that reliefs write, against those of the exact hits in double precision, in
// every kind of projection and depth range.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

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

// How far off the window depth of a point may be that is computed in floats: clip.z and clip.w are
// sums of four products, each off by no more than 4ε of the products' absolute values (Higham, ch.
// 3), and the point itself by that of its interpolation, the ray and the hit's t: some 16ε of the
// lengths that it is made of, which here are under 4.
double depthBound(const Camera& camera, const glm::dvec3& position) {
    constexpr double kEpsilon = std::numeric_limits<float>::epsilon() / 2;
    const glm::dmat4 matrix(camera.viewProjection);
    const glm::dvec4 point(position, 1.0);
    glm::dvec4 magnitude(0.0);
    for (int column = 0; column < 4; ++column)
        magnitude += glm::abs(matrix[column] * point[column]);
    const glm::dvec4 clip = matrix * point;
    const double device = clip.z / clip.w;
    const double product = 4 * kEpsilon * (magnitude.z + std::abs(device) * magnitude.w);
    double moved = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        moved += 64 * kEpsilon * std::abs(matrix[axis].z - device * matrix[axis].w);
    const double share = (camera.depth.zeroToOne ? 1.0 : 0.5) * (product + moved) / clip.w;
    return std::abs(camera.depth.range.y - camera.depth.range.x) * share + 4 * kEpsilon;
}

struct Agreement {
    std::size_t compared = 0;
    std::size_t differing = 0;  // one of them has a hit and the other has not
    double worst = 0.0;         // greatest difference as a multiple of the bound
};

Agreement compare(const std::vector<float>& depths,
                  const std::vector<std::optional<ExactHit>>& hits, const Camera& camera) {
    const float clear = fallsWithDistance(camera.depth) ? 0.0f : 1.0f;
    Agreement agreement;
    for (std::size_t k = 0; k < depths.size(); ++k) {
        const bool isDrawn = depths[k] != clear;
        agreement.differing += isDrawn != hits[k].has_value();
        if (!isDrawn || !hits[k])
            continue;
        ++agreement.compared;
        const double exact = windowDepth(camera, hits[k]->position);
        const double bound = depthBound(camera, hits[k]->position);
        agreement.worst =
            std::max(agreement.worst, std::abs(static_cast<double>(depths[k]) - exact) / bound);
    }
    return agreement;
}

TEST_P(DepthWrite, IsThatOfTheExactHit) {
    const Camera camera = makeCamera(GetParam());
    const auto hits = exactHits(camera);
    const std::vector<float> depths = drawnDepths(camera);
    const Agreement agreement = compare(depths, hits, camera);
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
        const Agreement agreement = compare(depthsOfProgram(camera, wrong), hits, camera);
        EXPECT_TRUE(agreement.worst > 1000.0 || agreement.differing > agreement.compared / 2)
            << otherClip << ": " << agreement.worst;
    }
    EXPECT_LE(compare(depthsOfProgram(camera, camera.depth), hits, camera).worst, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Projections, DepthWrite, testing::ValuesIn(everyProjection()), nameOf);

}  // namespace
}  // namespace relievo::viewer
