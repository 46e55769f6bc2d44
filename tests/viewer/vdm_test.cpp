// The technique `vdm` is exact where its table is: for the tabulated views, at the centres of
// texels. The rest is interpolation, which the error budgets of the registry hold.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

constexpr int kMapSize = 32;

// Tables of 16 azimuths and 4 elevations; three curvatures, so that the plane is not the first.
preprocess::ReliefPlan tablePlan(int terms) {
    preprocess::ReliefPlan plan;
    plan.maps = {"depth", "derivative", "vdm"};
    plan.views = {.azimuths = 16, .elevations = 4, .curvatures = 3};
    plan.terms = terms;
    return plan;
}

textures::MapSet bakeTable(textures::WrapMode wrap, int terms) {
    textures::DepthMap map = textures::generateSampleRelief("cobbles", kMapSize, kMapSize);
    map.wrap = wrap;
    return preprocess::bakeRelief(map, tablePlan(terms));
}

// The greatest error in texels over `tiles`² tiles, of which a pixel is a texel.
double greatestError(RayScene& scene, int tiles) {
    scene.renderer.setSurface(
        surfaces::makeQuad({static_cast<float>(tiles), static_cast<float>(tiles)}, 1.0f));
    return kMapSize *
           scene.errors(materials::findTechnique("vdm"), tiles * kMapSize).maximumDistance;
}

class VdmTest : public testing::Test {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// Distances are rounded down by parts of a millionth, and weights and angles are floats.
constexpr double kRounding = 1e-3;

void expectTabulatedViewsExact(textures::WrapMode wrap, int terms, int tiles) {
    SCOPED_TRACE(testing::Message() << "wrap " << static_cast<int>(wrap) << ", terms " << terms);
    RayScene scene(bakeTable(wrap, terms), 0.0f, 90.0f);
    for (const float azimuth : {0.0f, 22.5f, 112.5f, 247.5f, 292.5f})
        for (const float elevation : {90.0f, 45.0f, 22.5f}) {
            scene.look(azimuth, elevation);
            EXPECT_LT(greatestError(scene, tiles), kRounding)
                << "azimuth " << azimuth << ", elevation " << elevation;
        }
}

TEST_F(VdmTest, TabulatedViewsAreExact) {
    expectTabulatedViewsExact(textures::WrapMode::Repeat, 0, 2);
    expectTabulatedViewsExact(textures::WrapMode::Mirror, 0, 2);
    // The table is that of the tile: beyond it a clamped relief is another one.
    expectTabulatedViewsExact(textures::WrapMode::Clamp, 0, 1);
}

// Four elevations and three curvatures: twelve terms leave nothing out.
TEST_F(VdmTest, ThePackedTableIsTheSame) {
    expectTabulatedViewsExact(textures::WrapMode::Mirror, 12, 2);
}

// tan e at the scale of the table is tan e'·A/A' at another one.
TEST_F(VdmTest, ServesEveryDepthScale) {
    RayScene scene(bakeTable(textures::WrapMode::Repeat, 0), 0.0f, 90.0f);
    for (const double scale : {0.03, 0.2}) {
        const double elevation =
            std::atan(std::tan(std::numbers::pi / 4) * scale / 0.1) * 180.0 / std::numbers::pi;
        scene.look(22.5f, static_cast<float>(elevation), static_cast<float>(scale));
        EXPECT_LT(greatestError(scene, 1), kRounding) << scale;
    }
}

TEST_F(VdmTest, AWrongScaleIsCaught) {
    textures::MapSet maps = bakeTable(textures::WrapMode::Repeat, 0);
    maps.attributes["relievo:vdm-scale"] = "0.11";
    RayScene scene(maps, 22.5f, 45.0f);
    EXPECT_GT(greatestError(scene, 1), 100 * kRounding);
}

}  // namespace
}  // namespace relievo::viewer
