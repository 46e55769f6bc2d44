// The microfacet model as the shader computes it: energy, reciprocity, Fresnel, metals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "gl/context.h"
#include "gl/framebuffer.h"
#include "shaders/shader_library.h"
#include "tests/gl/full_screen_pass.h"

namespace relievo::materials {
namespace {

constexpr int kWidth = 128;  // of the frames that evaluate it
constexpr glm::dvec3 kNormal{0, 0, 1};
constexpr double kPi = std::numbers::pi;

constexpr const char* kFragment = R"glsl(
#include "relievo/shading/microfacet.glsl"
uniform sampler2D lights;
uniform sampler2D eyes;
uniform vec3 albedo;
uniform float roughness;
uniform float metalness;
layout(location = 0) out vec4 result;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ReliefAppearance appearance = ReliefAppearance(albedo, roughness, metalness, 1.0);
    vec3 normal = vec3(0.0, 0.0, 1.0);
    vec3 toLight = texelFetch(lights, pixel, 0).xyz;
    vec3 toEye = texelFetch(eyes, pixel, 0).xyz;
    result = vec4(reliefFacetReflection(appearance, normal, toLight, toEye) +
                  reliefBodyReflection(appearance, normal, toLight, toEye), 1.0);
}
)glsl";

struct Substance {
    glm::dvec3 albedo{1.0};
    double roughness = 0.5;
    double metalness = 0.0;
};

struct Directions {
    glm::dvec3 light;
    glm::dvec3 eye;
};

// Of unit length, at an angle with this cosine to the normal.
glm::dvec3 direction(double cosine, double azimuth = 0.0) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

class Microfacet : public testing::Test {
  protected:
    // π times the reflectance times the light's cosine, for each pair.
    std::vector<glm::dvec3> evaluate(const Substance& substance,
                                     const std::vector<Directions>& pairs) {
        const int height = static_cast<int>((pairs.size() + kWidth - 1) / kWidth);
        const gl::Texture lights = upload(pairs, height, &Directions::light);
        const gl::Texture eyes = upload(pairs, height, &Directions::eye);
        lights.bind(0);
        eyes.bind(1);
        program_.set("lights", 0);
        program_.set("eyes", 1);
        program_.set("albedo", glm::vec3(substance.albedo));
        program_.set("roughness", static_cast<float>(substance.roughness));
        program_.set("metalness", static_cast<float>(substance.metalness));
        gl::Framebuffer target(kWidth, height, std::array<GLenum, 1>{GL_RGBA32F});
        gl::tests::drawFullScreen(program_, target);
        const std::vector<float> texels = target.read(0);
        std::vector<glm::dvec3> result;
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            // Rows are read from the top, fragments count from the bottom.
            const std::size_t row = static_cast<std::size_t>(height) - 1 - k / kWidth;
            const float* texel = &texels[4 * (row * kWidth + k % kWidth)];
            result.emplace_back(texel[0], texel[1], texel[2]);
        }
        return result;
    }

    // The share of the light from everywhere that is reflected to `eye`.
    glm::dvec3 reflected(const Substance& substance, const glm::dvec3& eye);
    // The facets' share of a light, without the body under them.
    double facets(double roughness, const Directions& pair) {
        return evaluate({glm::dvec3(0.0), roughness, 0.0}, {pair}).front().x;
    }

  private:
    static gl::Texture upload(const std::vector<Directions>& pairs, int height,
                              glm::dvec3 Directions::*which) {
        std::vector<float> texels(4 * static_cast<std::size_t>(kWidth * height));
        for (std::size_t k = 0; k < pairs.size(); ++k)
            for (int axis = 0; axis < 3; ++axis)
                texels[4 * k + static_cast<std::size_t>(axis)] =
                    static_cast<float>((pairs[k].*which)[axis]);
        gl::Texture texture(kWidth, height, GL_RGBA32F);
        texture.upload(texels, 4);
        return texture;
    }

    std::unique_ptr<gl::Context> context_ = gl::createContext(gl::Backend::OSMesa, {.debug = true});
    gl::Program program_ = gl::tests::fullScreenProgram(
        shaders::expandShader("test", kFragment, "#version 450 core").text);
};

// Directions to light from, and how densely they lie around each: half of them spread like the
// cosine, half like what facets mirror, so that narrow lobes are met.
struct LightSamples {
    std::vector<Directions> pairs;
    std::vector<double> densities;
};

double mirroredDensity(const glm::dvec3& halfway, const glm::dvec3& eye, double width) {
    const double spread = halfway.z * halfway.z * (width * width - 1.0) + 1.0;
    const double facets = width * width / (kPi * spread * spread);
    return facets * halfway.z / (4.0 * glm::dot(eye, halfway));
}

LightSamples sampleLights(const glm::dvec3& eye, double width) {
    constexpr int kRings = 96;
    constexpr int kAzimuths = 64;
    LightSamples samples;
    for (int ring = 0; ring < kRings; ++ring)
        for (int k = 0; k < kAzimuths; ++k) {
            const double share = (ring + 0.5) / kRings;
            const double azimuth = 2.0 * kPi * (k + 0.5) / kAzimuths;
            const double tangent = width * std::sqrt(share / (1.0 - share));
            const glm::dvec3 halfway = direction(1.0 / std::hypot(1.0, tangent), azimuth);
            const glm::dvec3 mirrored = 2.0 * glm::dot(eye, halfway) * halfway - eye;
            for (const glm::dvec3& light : {direction(std::sqrt(share), azimuth), mirrored}) {
                samples.pairs.push_back({light, eye});
                const glm::dvec3 between = glm::normalize(light + eye);
                samples.densities.push_back(0.5 * std::max(light.z, 0.0) / kPi +
                                            0.5 * mirroredDensity(between, eye, width));
            }
        }
    return samples;
}

glm::dvec3 Microfacet::reflected(const Substance& substance, const glm::dvec3& eye) {
    const double width = std::max(substance.roughness * substance.roughness, 0.00465);
    const LightSamples samples = sampleLights(eye, width);
    const std::vector<glm::dvec3> values = evaluate(substance, samples.pairs);
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < values.size(); ++k)
        if (samples.pairs[k].light.z > 0.0)
            sum += values[k] / (kPi * samples.densities[k]);
    return sum / static_cast<double>(values.size());
}

// A white furnace: nothing reflects more than arrives, and what is white and smooth reflects all of
// it.
TEST_F(Microfacet, ReflectsNoMoreThanArrives) {
    for (const double cosine : {1.0, 0.7, 0.4, 0.2, 0.1, 0.05})
        for (const double roughness : {0.0, 0.15, 0.3, 0.5, 0.8, 1.0})
            for (const double metalness : {0.0, 0.5, 1.0}) {
                const double share =
                    reflected({glm::dvec3(1.0), roughness, metalness}, direction(cosine)).x;
                SCOPED_TRACE(testing::Message()
                             << "cosine " << cosine << ", roughness " << roughness << ", metalness "
                             << metalness << ": " << share);
                EXPECT_LT(share, 1.002);
                EXPECT_GT(share, roughness == 0.0 && cosine >= 0.1 ? 0.99 : 0.0);
            }
}

// What rough facets shadow is lost, since they are followed for one reflection only. For a width of
// 1 they face everywhere alike, and seen straight on the integral is ∫ μ/(1 + μ) dμ.
TEST_F(Microfacet, RoughFacetsLoseWhatTheClosedFormSays) {
    EXPECT_NEAR(reflected({glm::dvec3(1.0), 1.0, 1.0}, direction(1.0)).x, 1.0 - std::log(2.0),
                5e-4);
}

// A body that is lit as if there were no facets above it gives back too much.
TEST_F(Microfacet, TheFurnaceSeesABodyThatTakesMoreThanTheFacetsLeave) {
    const glm::dvec3 eye = direction(0.1);
    const double facets = reflected({glm::dvec3(0.0), 0.2, 0.0}, eye).x;
    EXPECT_GT(facets + 1.0, 1.3);
}

TEST_F(Microfacet, IsReciprocal) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> uniform(0.02, 1.0);
    std::vector<Directions> there;
    std::vector<Directions> back;
    for (int k = 0; k < 500; ++k) {
        const glm::dvec3 light = direction(uniform(generator), 6.0 * uniform(generator));
        const glm::dvec3 eye = direction(uniform(generator), 6.0 * uniform(generator));
        there.push_back({light, eye});
        back.push_back({eye, light});
    }
    for (const Substance& substance :
         {Substance{{0.8, 0.5, 0.2}, 0.3, 0.0}, Substance{{0.8, 0.5, 0.2}, 0.7, 1.0}}) {
        const auto a = evaluate(substance, there);
        const auto b = evaluate(substance, back);
        double withoutCosines = 0.0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            const glm::dvec3 one = a[k] / there[k].light.z;
            const glm::dvec3 other = b[k] / back[k].light.z;
            ASSERT_LT(glm::length(one - other), 1e-4 * (1.0 + glm::length(one)));
            withoutCosines = std::max(withoutCosines, glm::length(a[k] - b[k]));
        }
        EXPECT_GT(withoutCosines, 0.01);
    }
}

TEST_F(Microfacet, FacetsFollowSchlickToAMirrorAtGrazingAngles) {
    for (const double cosine : {1.0, 0.5, 0.2, 0.05, 0.002}) {
        // Mirrored directions: the facets that answer face along the normal.
        const Directions pair{direction(cosine), direction(cosine, kPi)};
        const double white = evaluate({glm::dvec3(1.0), 0.4, 1.0}, {pair}).front().x;
        const double dielectric = facets(0.4, pair);
        EXPECT_NEAR(dielectric / white, 0.04 + 0.96 * std::pow(1.0 - cosine, 5.0), 1e-3) << cosine;
    }
}

TEST_F(Microfacet, MetalsHaveNoBodyAndColouredReflections) {
    const glm::dvec3 gold(1.0, 0.75, 0.3);
    // Away from the mirrored direction there are only the tails of the lobe.
    const Directions aside{direction(0.5), direction(1.0)};
    EXPECT_LT(evaluate({gold, 0.1, 1.0}, {aside}).front().x, 0.01);
    EXPECT_GT(evaluate({gold, 0.1, 0.0}, {aside}).front().x, 0.4);
    const glm::dvec3 straight = reflected({gold, 0.1, 1.0}, direction(1.0));
    EXPECT_LT(glm::length(straight - gold), 0.01);
    const glm::dvec3 grazing = reflected({gold, 0.1, 1.0}, direction(0.1));
    EXPECT_GT(grazing.z, 0.65);
}

TEST_F(Microfacet, StaysFiniteForAnyDirections) {
    std::vector<Directions> pairs;
    for (const double light : {1.0, 1e-4, 1e-8, 0.0, -0.5})
        for (const double eye : {1.0, 0.5, 1e-8, 0.0, -1e-3, -0.7, -1.0})
            for (const double azimuth : {0.0, 1.0, kPi})
                pairs.push_back({direction(light), direction(eye, azimuth)});
    for (const double roughness : {0.0, 1e-3, 1.0})
        for (const glm::dvec3& value : evaluate({glm::dvec3(1.0), roughness, 0.5}, pairs))
            ASSERT_TRUE(std::isfinite(value.x) && value.x >= 0.0) << value.x;
}

}  // namespace
}  // namespace relievo::materials
