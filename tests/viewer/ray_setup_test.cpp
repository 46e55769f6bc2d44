// The rays that the shader searches along, and the depth that it writes, against the same geometry
// in double precision on the CPU.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/mat4x4.hpp>

#include "materials/technique_registry.h"
#include "reference/bilinear_tracer.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

constexpr int kWidth = 60;
constexpr int kHeight = 40;

// The quad of makeQuad in double precision.
struct ExactQuad {
    glm::dvec2 tiles;
    double aspect;

    glm::dvec2 uvAt(const glm::dvec3& world) const {
        const double height = aspect * tiles.y / tiles.x;
        return {(world.x + 0.5) * tiles.x, (0.5 - world.y / height) * tiles.y};
    }
};

struct ExactRay {
    glm::dvec2 uv;
    glm::dvec3 direction;  // in tile space, of length 1 in the metric
};

ExactRay exactRay(const Camera& camera, const ExactQuad& quad, int x, int y, double depthScale) {
    const glm::dmat4 inverse = glm::inverse(glm::dmat4(camera.viewProjection));
    const glm::dvec2 device((x + 0.5) / kWidth * 2 - 1, 1 - (y + 0.5) / kHeight * 2);
    const glm::dvec4 far = inverse * glm::dvec4(device, 1.0, 1.0);
    const glm::dvec3 eye(camera.eye);
    const glm::dvec3 view = glm::normalize(glm::dvec3(far) / far.w - eye);
    const glm::dvec3 entry = eye - view * (eye.z / view.z);
    // A step along the view sinks by −view.z, of which the relief's depth is depthScale/tiles.x.
    const glm::dvec2 uvStep = quad.uvAt(entry + view) - quad.uvAt(entry);
    glm::dvec3 direction(uvStep, -view.z * quad.tiles.x / depthScale);
    direction /= glm::length(glm::dvec3(direction.x, quad.aspect * direction.y, direction.z));
    return {quad.uvAt(entry), direction};
}

class RaySetup : public testing::Test {
  protected:
    // A non-square map, tiled unevenly, in perspective.
    RaySetup()
        : map_(textures::generateSampleRelief("wave", 64, 32)),
          quad_{{2.0, 3.0}, 0.5},
          renderer_(bakeMaps(map_), "test", {}) {
        renderer_.setSurface(surfaces::makeQuad({2, 3}, 0.5f));
        OrbitCamera orbit;
        orbit.distance = 1.3f;
        view_.camera = perspectiveCamera(orbit, static_cast<float>(kWidth) / kHeight);
        view_.window = {0, 0, 2, 3};
        view_.depthScale = 0.2f;
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    textures::DepthMap map_;
    ExactQuad quad_;
    SceneRenderer renderer_;
    View view_;
};

// The largest deviation of the shader's rays from the exact ones.
double rayDeviation(const MeasuredFrame& frame, const View& view, const ExactQuad& quad,
                    double depthScale) {
    double deviation = 0.0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const MeasuredPixel& pixel = frame.pixels[static_cast<std::size_t>(y * kWidth + x)];
            if (!pixel.covered)
                continue;
            const ExactRay ray = exactRay(view.camera, quad, x, y, depthScale);
            deviation = std::max({deviation,
                                  glm::length(glm::dvec2(pixel.origin.x, pixel.origin.y) - ray.uv),
                                  glm::length(glm::dvec3(pixel.direction) - ray.direction)});
        }
    return deviation;
}

TEST_F(RaySetup, AgreesWithDoublePrecision) {
    materials::ReliefMaterial material = renderer_.makeMaterial(materials::findTechnique("normal"));
    const MeasuredFrame frame = renderer_.measure(material, view_, kWidth, kHeight);
    ASSERT_GT(countWork(frame).pixels, 500u);
    EXPECT_LT(rayDeviation(frame, view_, quad_, view_.depthScale), 2e-5);
    // The check sees a ray set up for another depth scale or a square map.
    EXPECT_GT(rayDeviation(frame, view_, quad_, 1.1 * view_.depthScale), 1e-3);
    EXPECT_GT(rayDeviation(frame, view_, {quad_.tiles, 1.0}, view_.depthScale), 1e-3);
}

// Where a ray leaves the window above the relief there is a measurement too, or a technique that
// misses what is there would not be found out.
TEST_F(RaySetup, RecordsMissesAsWell) {
    materials::ReliefMaterial material = renderer_.makeMaterial(materials::findTechnique("exact"));
    const MeasuredFrame frame = renderer_.measure(material, view_, kWidth, kHeight);
    const ReferenceFrame exact = renderer_.trace(view_, kWidth, kHeight);
    std::size_t misses = 0;
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
        ASSERT_EQ(frame.pixels[k].covered, exact.pixels[k].covered);
        if (!frame.pixels[k].covered)
            continue;
        misses += !exact.pixels[k].hit;
        EXPECT_EQ(frame.pixels[k].outcome == RELIEVO_OUTCOME_HIT, exact.pixels[k].hit);
    }
    EXPECT_GT(misses, 20u);
}

TEST_F(RaySetup, HitsStayInsideTheWindow) {
    for (const materials::Technique& technique : materials::techniques()) {
        SceneRenderer renderer(bakeMapsFor(technique, map_), "test", {});
        renderer.setSurface(surfaces::makeQuad({2, 3}, 0.5f));
        materials::ReliefMaterial material = renderer.makeMaterial(technique);
        for (const MeasuredPixel& pixel :
             renderer.measure(material, view_, kWidth, kHeight).pixels) {
            if (!pixel.covered || pixel.outcome != RELIEVO_OUTCOME_HIT)
                continue;
            EXPECT_TRUE(pixel.hit.x >= 0 && pixel.hit.x <= 2 && pixel.hit.y >= 0 &&
                        pixel.hit.y <= 3 && pixel.hit.z >= 0 && pixel.hit.z <= 1.0001f)
                << technique.name;
        }
    }
}

TEST_F(RaySetup, BoxFacesSeeTheirOwnRelief) {
    renderer_.setSurface(surfaces::makeBox({1, 1}));
    view_.window = {0, 0, 1, 1};
    materials::ReliefMaterial material = renderer_.makeMaterial(materials::findTechnique("relief"));
    const MeasuredFrame frame = renderer_.measure(material, view_, kWidth, kHeight);
    const ReferenceFrame exact = renderer_.trace(view_, kWidth, kHeight);
    const auto errors = reference::summarizeErrors(
        compareFrames(frame, exact, map_, view_.depthScale), 1.0 / map_.width());
    EXPECT_GT(errors.rays, 500u);
    EXPECT_LT(errors.wrongShare, 0.03);
}

}  // namespace
}  // namespace relievo::viewer
