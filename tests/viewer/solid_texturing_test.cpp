// Where pictures lie on solids, against the formulas of the thesis and finite differences; and
// reliefs on walls.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "bilinear_relief.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "shaders/shader_library.h"
#include "tests/gl/full_screen_pass.h"
#include "viewer/picture.h"
#include "viewer/solid_stage.h"

namespace relievo::viewer {
namespace {

using solids::SolidTexturing;

constexpr int kPixels = 48;
constexpr std::array kAllTexturings{SolidTexturing::PlanarZ,        SolidTexturing::PlanarY,
                                    SolidTexturing::PlanarDiagonal, SolidTexturing::Cylindrical,
                                    SolidTexturing::Spherical,      SolidTexturing::Box};

constexpr const char* kFragment = R"glsl(
#include "relievo/solid/texturing.glsl"
uniform float depth;
uniform vec3 covector;
in vec2 uv;
layout(location = 0) out vec4 placeOutput;
layout(location = 1) out vec4 uvOutput;
layout(location = 2) out vec4 uOutput;
layout(location = 3) out vec4 vOutput;
void main() {
    vec3 place = vec3(4.0 * uv - 1.0, depth);
    SolidTexturing texturing = solidTexturing(0, place, covector);
    placeOutput = vec4(place, 0.0);
    uvOutput = vec4(texturing.uv, 0.0, 0.0);
    uOutput = vec4(texturing.gradientU, 0.0);
    vOutput = vec4(texturing.gradientV, 0.0);
}
)glsl";

std::shared_ptr<const textures::ShapeMap> halfPlane() {
    constexpr int kTexels = 16;
    auto shape = std::make_shared<textures::ShapeMap>();
    shape->wrap = textures::WrapMode::Clamp;
    shape->distance = shape->gradientX = shape->gradientY = shape->shape =
        textures::Plane(kTexels, kTexels);
    for (int j = 0; j < kTexels; ++j)
        for (int i = 0; i < kTexels; ++i) {
            shape->distance.at(i, j) = (static_cast<float>(i) + 0.5f) / kTexels - 0.5f;
            shape->gradientX.at(i, j) = 1.0f;
        }
    return shape;
}

solids::SolidPart halfBlock(solids::SolidKind kind = solids::SolidKind::Extrusion) {
    solids::SolidPart part;
    part.solid.shape = halfPlane();
    part.solid.kind = kind;
    part.solid.axis = {0.4, 0.55};
    return part;
}

// The formulas of the thesis (4.6.3), in double precision.
glm::dvec2 expectedUv(SolidTexturing texturing, const glm::dvec3& place, const glm::dvec2& axis,
                      const glm::dvec3& covector) {
    const glm::dvec3 p = place - glm::floor(place);
    const double phi = std::atan2(p.y - axis.y, p.x - axis.x);
    const double around = (std::numbers::pi - phi) / (2.0 * std::numbers::pi);
    const double radius = glm::length(p - glm::dvec3(axis, 0.5));
    switch (texturing) {
        case SolidTexturing::PlanarZ:
            return {p.x, p.y};
        case SolidTexturing::PlanarY:
            return {p.x, p.z};
        case SolidTexturing::PlanarDiagonal:
            return {0.5 * (p.x + p.y), p.z};
        case SolidTexturing::Cylindrical:
            return {around, p.z};
        case SolidTexturing::Spherical:
            return {around,
                    (std::numbers::pi - std::acos((p.z - 0.5) / radius)) / std::numbers::pi};
        case SolidTexturing::Box:
            break;
    }
    const glm::dvec3 facing = glm::abs(covector);
    if (facing.z >= std::max(facing.x, facing.y))
        return {p.x, p.y};
    return {facing.y > facing.x ? p.x : p.y, p.z};
}

struct Texel {
    glm::dvec3 place;
    glm::dvec2 uv;
    glm::dvec3 gradientU;
    glm::dvec3 gradientV;
};

class Texturing : public testing::Test {
  protected:
    std::vector<Texel> evaluate(SolidTexturing texturing, solids::SolidKind kind, double depth,
                                const glm::vec3& covector) {
        materials::SolidMaterial material(shapes_, {{halfBlock(kind)}},
                                          materials::findSolidTechnique("solid"));
        material.looks.front().texturing = texturing;
        const shaders::ExpandedShader text =
            shaders::expandShader("test", kFragment, "#version 450 core", material.defines());
        gl::Program program = gl::tests::fullScreenProgram(text.text);
        program.set("depth", static_cast<float>(depth));
        program.set("covector", covector);
        material.bind(program.id());
        std::array<GLenum, 4> formats;
        formats.fill(GL_RGBA32F);
        gl::Framebuffer target(kPixels, kPixels, formats);
        gl::tests::drawFullScreen(program, target);
        std::array<std::vector<float>, 4> planes;
        for (int k = 0; k < 4; ++k)
            planes[static_cast<std::size_t>(k)] = target.read(k);
        std::vector<Texel> texels(kPixels * kPixels);
        const auto vectorOf = [&](std::size_t plane, std::size_t k) {
            const float* value = &planes[plane][4 * k];
            return glm::dvec3(value[0], value[1], value[2]);
        };
        for (std::size_t k = 0; k < texels.size(); ++k)
            texels[k] = {vectorOf(0, k), glm::dvec2(vectorOf(1, k)), vectorOf(2, k),
                         vectorOf(3, k)};
        return texels;
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    std::shared_ptr<materials::ShapeTextureCache> shapes_ =
        std::make_shared<materials::ShapeTextureCache>();
};

// The difference of two places on a picture that repeats.
double wrapped(double difference) {
    return std::abs(difference - std::round(difference));
}

TEST_F(Texturing, FollowsTheFormulasOnEveryReplica) {
    const glm::dvec2 axis(0.4, 0.55);
    for (const SolidTexturing texturing : kAllTexturings)
        for (const glm::vec3 covector :
             {glm::vec3(1, 0.2f, 0), glm::vec3(0.1f, -1, 0.3f), glm::vec3(0, 0.1f, -1)})
            for (const double depth : {0.3, 1.7}) {
                double largest = 0.0;
                for (const Texel& texel :
                     evaluate(texturing, solids::SolidKind::Revolution, depth, covector)) {
                    const glm::dvec2 off =
                        texel.uv - expectedUv(texturing, texel.place, axis, glm::dvec3(covector));
                    largest = std::max({largest, wrapped(off.x), wrapped(off.y)});
                }
                EXPECT_LT(largest, 2e-5) << solids::solidTexturingName(texturing);
            }
}

TEST_F(Texturing, GradientsAreThoseOfTheFormulas) {
    const glm::dvec2 axis(0.4, 0.55);
    const glm::vec3 covector(1, 0.2f, 0);
    constexpr double kStep = 1e-6;
    for (const SolidTexturing texturing : kAllTexturings) {
        double largest = 0.0;
        for (const Texel& texel :
             evaluate(texturing, solids::SolidKind::Revolution, 0.3, covector)) {
            const glm::dvec3 inTile = texel.place - glm::floor(texel.place);
            // Off the borders of replicas, the axis and the seam, where there is no derivative.
            const glm::dvec2 across = glm::dvec2(inTile) - axis;
            if (glm::length(across) < 0.1 || (across.x < 0.0 && std::abs(across.y) < 0.01) ||
                std::min({inTile.x, inTile.y, 1.0 - inTile.x, 1.0 - inTile.y}) < 0.01)
                continue;
            for (int direction = 0; direction < 3; ++direction) {
                glm::dvec3 step(0.0);
                step[direction] = kStep;
                const glm::dvec2 slope =
                    (expectedUv(texturing, texel.place + step, axis, glm::dvec3(covector)) -
                     expectedUv(texturing, texel.place - step, axis, glm::dvec3(covector))) /
                    (2.0 * kStep);
                largest = std::max({largest, std::abs(slope.x - texel.gradientU[direction]),
                                    std::abs(slope.y - texel.gradientV[direction])});
            }
        }
        EXPECT_LT(largest, 1e-4) << solids::solidTexturingName(texturing);
    }
}

TEST_F(Texturing, AnExtrusionEndsWithItsPicture) {
    for (const Texel& texel :
         evaluate(SolidTexturing::PlanarY, solids::SolidKind::Extrusion, 1.0, glm::vec3(0, 1, 0)))
        ASSERT_NEAR(texel.uv.y, 1.0, 1e-6);
}

// A half block seen at its wall, with a relief on it.
class WallRelief : public testing::Test {
  protected:
    WallRelief() : stage_(materials::findSolidTechnique("solid")) {
        glm::dmat4 fromWhole(1.0);
        fromWhole[1][1] = fromWhole[2][2] = -1.0;
        fromWhole[3] = {-0.5, 0.5, 0.5, 1.0};
        material_ = &stage_.addBox({{halfBlock()}}, glm::dvec3(0.0), glm::dvec3(1.0), fromWhole);
    }
    Picture draw() {
        OrbitCamera orbit;
        orbit.azimuth = 80.0f;
        FrameView view;
        view.camera = perspectiveCamera(orbit, 1.0f);
        view.toLight = directionTowards(50.0f, 30.0f);
        gl::Framebuffer target = makeColorTarget(kPixels, kPixels);
        frames_.draw(stage_.objects({}), view, target);
        Picture picture(kPixels, kPixels);
        picture.rgba = target.read(0);
        return picture;
    }
    void putRelief(std::string_view technique, float depthScale) {
        const auto maps = std::make_shared<materials::ReliefMaps>(
            bakeMaps(textures::generateSampleRelief("noise", 64, 64)), "noise");
        material_->relief.emplace(maps, materials::findTechnique(technique));
        material_->relief->depthScale = depthScale;
    }
    static double difference(const Picture& a, const Picture& b) {
        double sum = 0.0;
        for (std::size_t k = 0; k < a.rgba.size(); ++k)
            sum += std::abs(static_cast<double>(a.rgba[k] - b.rgba[k]));
        return sum / static_cast<double>(a.rgba.size());
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    SolidStage stage_;
    FrameRenderer frames_;
    materials::SolidMaterial* material_ = nullptr;
};

TEST_F(WallRelief, WithoutDepthIsTheBareWall) {
    const Picture bare = draw();
    for (const std::string_view technique : {"normal", "exact", "relief"}) {
        putRelief(technique, 0.0f);
        EXPECT_LT(difference(draw(), bare), 1e-3) << technique;
        putRelief(technique, 0.1f);
        EXPECT_GT(difference(draw(), bare), 5e-3) << technique;
    }
}

TEST_F(WallRelief, IsDeepAndNoBumpMap) {
    putRelief("normal", 0.1f);
    const Picture bump = draw();
    putRelief("exact", 0.1f);
    const Picture deep = draw();
    EXPECT_GT(difference(bump, deep), 2e-3);
    // Two searches of one relief show the same.
    putRelief("pyramid", 0.1f);
    EXPECT_LT(difference(draw(), deep), 1e-4);
}

}  // namespace
}  // namespace relievo::viewer
