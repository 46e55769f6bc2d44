// Slopes from derivatives, stored normals and depths: one normal at every depth scale, in every
// wrap mode.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "bilinear_relief.h"
#include "materials/slope_sources.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"

namespace relievo::viewer {
namespace {

constexpr double kNormalScale = 0.1;  // a0 of the stored normals

double angle(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Normals of a scene that is seen from straight above, where every pixel shows the point it covers.
MeasuredFrame normalsOf(RayScene& scene, materials::SlopeSource source, float depthScale, int width,
                        int height) {
    scene.view.slopes = source;
    scene.view.depthScale = depthScale;
    materials::ReliefMaterial material =
        scene.renderer.makeMaterial(materials::findTechnique("normal"));
    return scene.renderer.measure(material, scene.view, width, height);
}

class Slopes : public testing::TestWithParam<const materials::SlopeSourceEntry*> {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// The largest angle between the normals of a frame and those of the formula at `depthScale`, over
// pixels a texel away from the border.
double deviation(const MeasuredFrame& frame, double aspect, double depthScale) {
    double largest = 0.0;
    for (const MeasuredPixel& pixel : frame.pixels) {
        const glm::dvec2 uv(pixel.hit.x, pixel.hit.y);
        if (pixel.covered && std::min({uv.x, uv.y, 1.0 - uv.x, 1.0 - uv.y}) > 0.05)
            largest = std::max(
                largest, angle(glm::dvec3(pixel.normal), bilinearNormalAt(uv, aspect, depthScale)));
    }
    return largest;
}

TEST_P(Slopes, AgreeWithTheAnalyticNormalAtEveryDepthScale) {
    constexpr double kAspect = 0.75;
    RayScene scene(bilinearMaps(64, 48), 0.0f, 90.0f);
    for (const float scale : {1e-3f, 0.01f, 0.1f, 0.5f, 1.0f, 10.0f}) {
        const MeasuredFrame frame = normalsOf(scene, GetParam()->source, scale, 70, 50);
        // Floats of the depths leave 6e-8·64 of a slope, which the scale multiplies.
        const double tolerance = 4e-6 * std::max(1.0f, scale);
        EXPECT_LT(deviation(frame, kAspect, scale), tolerance) << scale;
        // Normals of another scale, or of a tile as high as wide, are not taken for these.
        EXPECT_GT(deviation(frame, kAspect, 1.1 * scale), 5 * tolerance) << scale;
        EXPECT_GT(deviation(frame, 1.0, scale), 5 * tolerance) << scale;
    }
}

TEST_P(Slopes, AreStraightWithoutDepth) {
    RayScene scene(bilinearMaps(64, 48), 0.0f, 90.0f);
    for (const MeasuredPixel& pixel : normalsOf(scene, GetParam()->source, 0.0f, 70, 50).pixels)
        ASSERT_EQ(pixel.normal, glm::vec3(0, 0, 1));
}

// Central differences of the depths around a texel of any tile, under the map's wrap mode.
glm::dvec3 centralNormal(const textures::DepthMap& map, int i, int j, double depthScale) {
    const auto at = [&](int x, int y) { return static_cast<double>(map.at(x, y)); };
    const double texels = 0.5 * map.width();
    return glm::normalize(glm::dvec3(depthScale * texels * (at(i + 1, j) - at(i - 1, j)),
                                     depthScale * texels * (at(i, j + 1) - at(i, j - 1)), 1.0));
}

// Calls `check` with a sample relief in every wrap mode, and a scene of 4×4 tiles of it whose
// corner is the corner of the first one.
template <typename Check>
void forEveryWrapMode(std::string_view sample, int width, int height, const Check& check) {
    preprocess::ReliefPlan plan;
    plan.maps = {"depth", "derivative", "normal"};
    plan.normalScale = kNormalScale;
    for (const textures::WrapMode wrap :
         {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp}) {
        SCOPED_TRACE(std::string(textures::wrapModeName(wrap)));
        textures::DepthMap map = textures::generateSampleRelief(sample, width, height);
        map.wrap = wrap;
        RayScene scene(preprocess::bakeRelief(map, plan), 0.0f, 90.0f);
        scene.renderer.setSurface(surfaces::makeQuad({4, 4}, static_cast<float>(map.aspect())));
        check(map, scene);
    }
}

TEST_P(Slopes, FollowTheWrapModeIntoNeighbouringTiles) {
    forEveryWrapMode("cobbles", 32, 16, [&](const textures::DepthMap& map, RayScene& scene) {
        const int width = 4 * map.width();  // a pixel for each texel
        const int height = 4 * map.height();
        const MeasuredFrame frame = normalsOf(scene, GetParam()->source, 0.2f, width, height);
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const glm::vec3 normal =
                    frame.pixels[static_cast<std::size_t>(j * width + i)].normal;
                ASSERT_LT(angle(glm::dvec3(normal), centralNormal(map, i, j, 0.2)), 1e-4)
                    << i << ", " << j;
            }
    });
}

INSTANTIATE_TEST_SUITE_P(Sources, Slopes, testing::ValuesIn([] {
                             std::vector<const materials::SlopeSourceEntry*> entries;
                             for (const auto& entry : materials::slopeSources())
                                 entries.push_back(&entry);
                             return entries;
                         }()),
                         nameOfTest<materials::SlopeSourceEntry>);

// Between the texels too: differences of interpolated depths are interpolated differences.
TEST_F(Slopes, FromDepthsAreThoseOfTheDerivativeMap) {
    forEveryWrapMode("bricks", 48, 32, [](const textures::DepthMap&, RayScene& scene) {
        const auto normals = [&](materials::SlopeSource source) {
            return normalsOf(scene, source, 0.2f, 211, 173).pixels;
        };
        const auto mapped = normals(materials::SlopeSource::Derivative);
        const auto differences = normals(materials::SlopeSource::Height);
        for (std::size_t k = 0; k < mapped.size(); ++k)
            ASSERT_LT(angle(glm::dvec3(mapped[k].normal), glm::dvec3(differences[k].normal)), 1e-3)
                << mapped[k].hit.x << ", " << mapped[k].hit.y;
    });
}

// Stored normals that are taken for those of another scale are wrong at every scale but 0.
TEST_F(Slopes, OfNormalsNeedTheScaleThatTheyAreFor) {
    textures::MapSet maps = bilinearMaps(32, 32);
    maps.attributes["relievo:normal-scale"] = "1";
    RayScene scene(maps, 0.0f, 90.0f);
    const MeasuredFrame frame = normalsOf(scene, materials::SlopeSource::Normal, 0.5f, 40, 40);
    EXPECT_GT(deviation(frame, 1.0, 0.5), 0.1);
}

}  // namespace
}  // namespace relievo::viewer
