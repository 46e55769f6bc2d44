// Whole solids in their boxes: seen from every side and from inside, through each other and through
// a mesh, with their shadows, against rays traced in double precision.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "solids/solid_tracer.h"
#include "viewer/exact_scene.h"
#include "viewer/solid_stage.h"

namespace relievo::viewer {
namespace {

constexpr int kWidth = 120;
constexpr int kHeight = 90;

// The signed distance to a disc, exactly sampled.
std::shared_ptr<const textures::ShapeMap> disc(glm::dvec2 centre, double radius, int texels = 64) {
    auto shape = std::make_shared<textures::ShapeMap>();
    shape->wrap = textures::WrapMode::Clamp;
    shape->distance = shape->gradientX = shape->gradientY = shape->shape =
        textures::Plane(texels, texels);
    for (int j = 0; j < texels; ++j)
        for (int i = 0; i < texels; ++i) {
            const glm::dvec2 away = (glm::dvec2(i, j) + 0.5) / static_cast<double>(texels) - centre;
            const double length = glm::length(away);
            shape->distance.at(i, j) = static_cast<float>(length - radius);
            shape->gradientX.at(i, j) = static_cast<float>(away.x / length);
            shape->gradientY.at(i, j) = static_cast<float>(away.y / length);
            shape->shape.at(i, j) = length < radius ? 1.0f : 0.0f;
        }
    return shape;
}

solids::SolidPart extruded(double radius) {
    solids::SolidPart part;
    part.solid.shape = disc({0.47, 0.52}, radius);
    part.solid.profile = solids::makeProfile(0.0, 0.08, 0.4, solids::ProfileShape::Round);
    return part;
}

solids::SolidPart torus() {
    solids::SolidPart part;
    part.solid.shape = disc({0.3, 0.5}, 0.13);
    part.solid.kind = solids::SolidKind::Revolution;
    return part;
}

struct TracedBox {
    solids::SolidTracer tracer;
    glm::dmat4 worldFromWhole;
};

struct NearestHit {
    int object = -1;
    double distance = 1e30;
    double second = 1e30;  // distance of the next object
};

// A bevelled drum with a star-like bite out of it, a torus through its rim, and a plain wall.
class SolidBoxes : public testing::Test {
  protected:
    SolidBoxes() : stage_(materials::findSolidTechnique("solid")) {
        solids::SolidPart bite = torus();
        bite.operation = solids::BooleanOperation::Difference;
        add({{extruded(0.36), bite}}, glm::dmat4(1.0));
        add({{torus()}}, glm::translate(glm::dmat4(1.0), {0.45, -0.1, 0.15}) *
                             glm::rotate(glm::dmat4(1.0), 0.8, glm::dvec3(0.3, 1.0, 0.2)));
        wall_ = surfaces::placed(surfaces::makeQuad({1, 1}, 1.0f),
                                 glm::rotate(glm::mat4(1.0f), 1.2f, glm::vec3(1, 0, 0)));
        stage_.addPlain(wall_, glm::vec3(0.5f));
    }
    void add(solids::Compound compound, const glm::dmat4& placement) {
        glm::dmat4 fromWhole(1.0);
        fromWhole[1][1] = -1.0;
        fromWhole[2][2] = -0.6;
        fromWhole[3] = {-0.5, 0.5, 0.3, 1.0};
        boxes_.push_back({solids::SolidTracer(compound), placement * fromWhole});
        stage_.addBox(std::move(compound), glm::dvec3(0.0), glm::dvec3(1.0), placement * fromWhole);
    }
    [[nodiscard]] std::optional<double> hit(const TracedBox& box, const WorldRay& ray) const {
        const glm::dmat4 fromWorld = glm::inverse(box.worldFromWhole);
        // The rays of the box: it cuts the solid off.
        const glm::dvec3 origin(fromWorld * glm::dvec4(ray.origin, 1.0));
        const glm::dvec3 direction = glm::dmat3(fromWorld) * ray.direction;
        const auto found = box.tracer.firstHit({origin, direction, 100.0});
        if (!found)
            return std::nullopt;
        return found->t;
    }
    [[nodiscard]] NearestHit nearest(const WorldRay& ray) const {
        NearestHit result;
        const auto take = [&](int object, double distance) {
            if (distance < result.distance) {
                result = {object, distance, result.distance};
            } else {
                result.second = std::min(result.second, distance);
            }
        };
        for (std::size_t k = 0; k < boxes_.size(); ++k)
            if (const auto t = hit(boxes_[k], ray))
                take(static_cast<int>(k), *t);
        const ExactObject wall{&wall_, nullptr, 0.0, {}};
        if (const auto found = firstHit({&wall, 1}, ray))
            take(static_cast<int>(boxes_.size()), found->distance);
        return result;
    }
    // The share of pixels that show another object or a place more than `tolerance` off; edges of
    // silhouettes, where rounding decides, are some of them.
    double wrongShare(const Camera& camera, double tolerance) {
        FrameView view;
        view.camera = camera;
        const VisibleFrame frame = frames_.show(stage_.objects({}), view, kWidth, kHeight);
        int wrong = 0;
        std::array<int, 4> shown{};
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const WorldRay ray = pixelRay(camera, x, y, kWidth, kHeight);
                const NearestHit exact = nearest(ray);
                const VisiblePixel& pixel =
                    frame
                        .pixels[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)];
                ++shown[static_cast<std::size_t>(exact.object + 1)];
                if (pixel.object != exact.object) {
                    wrong += std::abs(exact.second - exact.distance) > tolerance ? 1 : 0;
                    continue;
                }
                if (exact.object < 0)
                    continue;
                const glm::dvec3 place = ray.origin + exact.distance * ray.direction;
                wrong += glm::distance(place, glm::dvec3(pixel.position)) > tolerance ? 1 : 0;
            }
        for (std::size_t k = 0; k < shown.size(); ++k)
            counts_[k] += shown[k];
        return static_cast<double>(wrong) / (kWidth * kHeight);
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    SolidStage stage_;
    FrameRenderer frames_;
    std::vector<TracedBox> boxes_;
    surfaces::SurfaceMesh wall_;
    std::array<int, 4> counts_{};  // pixels of the background and of each object
};

constexpr double kTolerance = 1e-3;  // world units: the boxes are 1 wide
// A pixel of a frame: where a ray grazes a silhouette rounding decides, and processors round alike
// but in fused products.
constexpr double kMostWrong = 1.0 / (kWidth * kHeight);

TEST_F(SolidBoxes, ShowTheNearestSurfaceFromEverySide) {
    for (const bool isReversed : {false, true})
        for (const float elevation : {60.0f, 15.0f, -50.0f})
            for (const float azimuth : {10.0f, 130.0f, 250.0f}) {
                OrbitCamera orbit;
                orbit.azimuth = azimuth;
                orbit.elevation = elevation;
                orbit.distance = 2.2f;
                EXPECT_LE(wrongShare(perspectiveCamera(orbit, 4.0f / 3.0f,
                                                       {isReversed, isReversed, {0.0f, 1.0f}}),
                                     kTolerance),
                          kMostWrong)
                    << azimuth << " " << elevation;
            }
    for (const int count : counts_)
        EXPECT_GT(count, 1000);
}

TEST_F(SolidBoxes, ShowTheSameInParallelProjection) {
    OrbitCamera orbit;
    orbit.elevation = 30.0f;
    EXPECT_LE(wrongShare(orthographicCamera(orbit, 4.0f / 3.0f), kTolerance), kMostWrong);
}

TEST_F(SolidBoxes, AreSeenFromInside) {
    // The eye is in both boxes, in front of the wall, and looks at what is around it.
    OrbitCamera orbit;
    orbit.target = {0.2f, -0.35f, 0.28f};
    orbit.distance = 0.05f;
    orbit.fieldOfView = 90.0f;
    for (const float azimuth : {0.0f, 90.0f, 180.0f, 270.0f}) {
        orbit.azimuth = azimuth;
        EXPECT_LE(wrongShare(perspectiveCamera(orbit, 4.0f / 3.0f), kTolerance), kMostWrong)
            << azimuth;
    }
    EXPECT_GT(counts_[1], 1000);
}

TEST_F(SolidBoxes, AreWrongWhereTheEyeLooksFromSomewhereElse) {
    OrbitCamera orbit;
    const Camera camera = perspectiveCamera(orbit, 4.0f / 3.0f);
    boxes_[1].worldFromWhole =
        glm::translate(glm::dmat4(1.0), {0.02, 0.0, 0.0}) * boxes_[1].worldFromWhole;
    EXPECT_GT(wrongShare(camera, kTolerance), 0.05);
}

TEST_F(SolidBoxes, ShadowThemselvesAsExactRaysDo) {
    OrbitCamera orbit;
    FrameView view;
    view.camera = perspectiveCamera(orbit, 4.0f / 3.0f);
    view.toLight = directionTowards(-60.0f, 25.0f);
    const SceneObject drum = stage_.objects({}).front();
    const MeasuredFrame frame = frames_.measure(drum, view, kWidth, kHeight);
    const glm::dmat4 fromWorld = glm::inverse(boxes_[0].worldFromWhole);
    const glm::dvec3 direction = glm::dmat3(fromWorld) * glm::dvec3(view.toLight);
    int compared = 0;
    int wrong = 0;
    int dark = 0;
    for (const MeasuredPixel& pixel : frame.pixels) {
        if (!pixel.covered || pixel.outcome != RELIEVO_OUTCOME_HIT)
            continue;
        const double facing = glm::dot(glm::dvec3(pixel.normal), glm::dvec3(view.toLight));
        // Where light grazes a surface of bilinear cells it depends on less than a texel.
        if (std::abs(facing) < 0.05)
            continue;
        ++compared;
        const glm::dvec3 origin = glm::dvec3(pixel.hit) + 1e-3 * direction;
        const bool isLit =
            facing > 0.0 && !boxes_[0].tracer.firstHit({origin, direction, 100.0}).has_value();
        dark += isLit ? 0 : 1;
        wrong += isLit != (pixel.lightShare > 0.5f) ? 1 : 0;
    }
    fmt::print("{} of {} pixels in shadow, {} wrong\n", dark, compared, wrong);
    EXPECT_GT(dark, compared / 10);
    EXPECT_LE(wrong, compared / 1000);
}

// A large map, where the digits of t end within a cell, and rays that go on behind many replicas.
TEST(SolidReplicas, NoRayRunsOutOfSteps) {
    const auto context = makeTestContext();
    SolidStage stage(materials::findSolidTechnique("solid"));
    solids::SolidPart part;
    part.solid.shape = disc({0.25, 0.6}, 0.2, 1024);
    part.solid.kind = solids::SolidKind::Revolution;
    part.windowMaximum = {5.0, 5.0, 1.0};
    materials::SolidMaterial& material =
        stage.addSurface({{part}}, surfaces::makeQuad({5.0f, 5.0f}, 1.0f));
    material.depthScale = 1.0f;
    OrbitCamera orbit;
    orbit.azimuth = 20.0f;
    orbit.elevation = 42.0f;
    orbit.distance = 0.8f;
    orbit.target = {0.0f, 0.0f, -0.15f};
    FrameView view;
    view.camera = perspectiveCamera(orbit, 4.0f / 3.0f);
    FrameRenderer frames;
    const WorkCounts work =
        countWork(frames.measure(stage.objects({}).front(), view, 2 * kWidth, 2 * kHeight));
    fmt::print("{} pixels, {:.2f} steps\n", work.pixels, work.meanSteps);
    EXPECT_GT(work.pixels, 20000u);
    EXPECT_EQ(work.exhausted, 0u);
}

}  // namespace
}  // namespace relievo::viewer
