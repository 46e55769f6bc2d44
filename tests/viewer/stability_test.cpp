// No technique may produce a NaN, an infinity, an unbounded search or a hit outside the relief, for
// any ray, scale, place or map. The environment variable RELIEVO_FRAME_SIZE makes the frames
// larger: 160 is a million rays for each technique.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "materials/program_cache.h"
#include "materials/technique_registry.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "tests/gl/full_screen_pass.h"

namespace relievo::viewer {
namespace {

int frameSize() {
    const char* const size = std::getenv("RELIEVO_FRAME_SIZE");
    return size == nullptr ? 24 : std::stoi(size);
}

textures::DepthMap noiseMap(int width, int height, textures::WrapMode wrap) {
    textures::DepthMap map{textures::Plane(width, height), wrap};
    std::mt19937 random(12345);
    for (float& depth : map.depth.texels)
        depth = static_cast<float>(random() >> 8) / 16777216.0f;
    return map;
}

textures::DepthMap binaryMap() {
    textures::DepthMap map = noiseMap(16, 16, textures::WrapMode::Repeat);
    for (float& depth : map.depth.texels)
        depth = depth > 0.5f ? 1.0f : 0.0f;
    return map;
}

textures::DepthMap loneSpike() {
    textures::DepthMap map{textures::Plane(32, 32, 1.0f), textures::WrapMode::Repeat};
    map.depth.at(13, 7) = 0.0f;
    return map;
}

struct HostileMap {
    const char* name;
    textures::DepthMap map;
    textures::ConeEncoding encoding = textures::ConeEncoding::Ratio;
};

std::vector<HostileMap> hostileMaps() {
    using textures::ConeEncoding;
    using textures::WrapMode;
    const auto level = [](float depth) {
        return textures::DepthMap{textures::Plane(8, 8, depth), WrapMode::Repeat};
    };
    return {{"level at the top", level(0.0f), ConeEncoding::Radius},
            {"level in the middle", level(0.5f)},
            {"level at the bottom", level(1.0f), ConeEncoding::Radius},
            {"one texel", noiseMap(1, 1, WrapMode::Repeat)},
            {"one column", noiseMap(1, 13, WrapMode::Mirror)},
            {"one row", noiseMap(64, 1, WrapMode::Clamp), ConeEncoding::Radius},
            {"noise", noiseMap(17, 11, WrapMode::Mirror), ConeEncoding::Radius},
            {"binary", binaryMap()},
            {"binary by radius", binaryMap(), ConeEncoding::Radius},
            {"lone spike", loneSpike()}};
}

// How a ray is drawn; elevations in degrees above the surface.
struct Regime {
    double lowest;
    double highest;
    bool isAlongAxis;
    double farthest;  // places in the plane of the tiles
};

// In turn: anything, grazing, along an axis, level, straight down, far from the first tile.
constexpr Regime kRegimes[] = {{0.01, 90.0, false, 3.0}, {0.01, 0.02, false, 3.0},
                               {0.01, 90.0, true, 3.0},  {0.0, 0.0, false, 3.0},
                               {90.0, 90.0, false, 3.0}, {0.1, 90.0, false, 1e5}};

// Places (u,v) and view directions for a frame, a regime after the other.
struct HostileRays {
    std::vector<float> places;
    std::vector<float> views;
};

HostileRays drawRays(int count) {
    std::mt19937 random(2026);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    HostileRays rays;
    for (int k = 0; k < count; ++k) {
        const Regime& regime = kRegimes[static_cast<std::size_t>(k) % std::size(kRegimes)];
        // Evenly in the logarithm, so that there are many near the horizon.
        const double elevation = regime.highest == 0.0
                                     ? 0.0
                                     : regime.lowest *
                                           std::pow(regime.highest / regime.lowest, share(random)) *
                                           std::numbers::pi / 180.0;
        const double azimuth = regime.isAlongAxis
                                   ? std::floor(4.0 * share(random)) * std::numbers::pi / 2.0
                                   : 2.0 * std::numbers::pi * share(random);
        // A cosine of a right angle is not quite 0, which would not be along the axis.
        const auto along = [&](double cosine) {
            const double part = std::cos(elevation) * cosine;
            return static_cast<float>(std::abs(part) < 1e-12 ? 0.0 : part);
        };
        for (int axis = 0; axis < 2; ++axis)
            rays.places.push_back(
                static_cast<float>((2.0 * share(random) - 1.0) * regime.farthest));
        rays.views.insert(rays.views.end(), {along(std::cos(azimuth)), along(std::sin(azimuth)),
                                             static_cast<float>(-std::sin(elevation))});
    }
    return rays;
}

// A quad whose every pixel is another ray.
constexpr const char* kFragment = R"glsl(
#include "relievo/material.glsl"
uniform sampler2D placeMap;
uniform sampler2D viewMap;
layout(location = RELIEVO_OUTPUT_HIT) out vec4 hitOutput;
layout(location = RELIEVO_OUTPUT_WORK) out vec4 workOutput;
layout(location = RELIEVO_OUTPUT_ORIGIN) out vec4 originOutput;
layout(location = RELIEVO_OUTPUT_DIRECTION) out vec4 directionOutput;
layout(location = RELIEVO_OUTPUT_NORMAL) out vec4 normalOutput;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ReliefSurface surface =
        ReliefSurface(vec3(0.0), vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0),
                      vec3(0.0, -reliefAspect(), 0.0), texelFetch(placeMap, pixel, 0).xy);
    ReliefFragment relief = traceRelief(surface, texelFetch(viewMap, pixel, 0).xyz);
    hitOutput = vec4(relief.hit.position, relief.hit.t);
    workOutput = vec4(float(relief.hit.outcome), float(relief.hit.steps),
                      float(relief.hit.fetches), 1.0);
    originOutput = vec4(relief.ray.origin, relief.ray.end);
    directionOutput = vec4(relief.ray.direction, relief.ray.worldLength);
    normalOutput = vec4(relief.tileNormal, 0.0);
}
)glsl";

gl::Program hostileProgram(const materials::ReliefMaterial& material) {
    const std::string text =
        "#include \"" + std::string(material.technique().file) + "\"\n" + kFragment;
    return gl::tests::fullScreenProgram(
        shaders::expandShader("hostile rays", text, "#version 450 core", material.defines()).text);
}

gl::Texture uploaded(const std::vector<float>& values, int size, GLenum format, int channels) {
    gl::Texture texture(size, size, format);
    texture.upload(values, channels);
    return texture;
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// No search takes more steps than its parameters, the numbers of steps of each kind, allow; and one
// step needs no parameter.
double mostSteps(const materials::ReliefMaterial& material) {
    double steps = 1.0;
    for (const materials::TechniqueParameter& parameter : material.technique().parameters)
        if (parameter.isInteger)
            steps += material.parameter(parameter.name);
    return steps;
}

bool isSound(const MeasuredPixel& pixel, double mostSteps) {
    const bool isBounded = pixel.steps <= mostSteps && pixel.t >= 0.0f;
    const bool isHit = pixel.outcome == RELIEVO_OUTCOME_HIT;
    const bool isInside = pixel.hit.z >= 0.0f && pixel.hit.z <= 1.001f;
    return isFinite(pixel.hit) && std::isfinite(pixel.t) && isFinite(pixel.normal) && isBounded &&
           (isHit ? isInside
                  : pixel.outcome == RELIEVO_OUTCOME_MISS ||
                        pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED);
}

class Stability : public testing::TestWithParam<const materials::Technique*> {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

TEST_P(Stability, HostileRaysAndMaps) {
    const int size = frameSize();
    const HostileRays rays = drawRays(size * size);
    const gl::Texture places = uploaded(rays.places, size, GL_RG32F, 2);
    const gl::Texture views = uploaded(rays.views, size, GL_RGB32F, 3);
    gl::Framebuffer target = makeMeasuredTarget(size, size);
    std::size_t exhausted = 0;
    std::size_t count = 0;
    for (const HostileMap& hostile : hostileMaps()) {
        const auto maps = std::make_shared<materials::ReliefMaps>(
            bakeMapsFor(*GetParam(), hostile.map, hostile.encoding), hostile.name);
        materials::ReliefMaterial material(maps, *GetParam());
        gl::Program program = hostileProgram(material);
        for (const float scale : {0.0f, 1e-6f, 0.1f, 1.0f, 1e3f}) {
            SCOPED_TRACE(fmt::format("{}, depth scale {}", hostile.name, scale));
            material.depthScale = scale;
            const GLuint unit = material.bind(program.id());
            program.set("placeMap", static_cast<int>(unit));
            program.set("viewMap", static_cast<int>(unit) + 1);
            places.bind(unit);
            views.bind(unit + 1);
            gl::tests::drawFullScreen(program, target);
            const MeasuredFrame frame = readMeasuredFrame(target);
            for (std::size_t k = 0; k < frame.pixels.size(); ++k)
                ASSERT_TRUE(frame.pixels[k].covered &&
                            isSound(frame.pixels[k], mostSteps(material)))
                    << "ray " << k;
            exhausted += countWork(frame).exhausted;
            count += frame.pixels.size();
        }
    }
    fmt::print("{:18} {} rays, {:.3f} % ran out of steps\n", GetParam()->name, count,
               100.0 * static_cast<double>(exhausted) / static_cast<double>(count));
}

INSTANTIATE_TEST_SUITE_P(Techniques, Stability, testing::ValuesIn(everyTechnique()),
                         nameOfTest<materials::Technique>);

// What the test above looks for, it would find.
TEST(Soundness, SeesWhatIsWrong) {
    MeasuredPixel sound;
    sound.steps = 5;
    ASSERT_TRUE(isSound(sound, 5));
    const auto broken = [&](const auto& breakIt) {
        MeasuredPixel pixel = sound;
        breakIt(pixel);
        return !isSound(pixel, 5);
    };
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.hit.x = std::nanf(""); }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.t = HUGE_VALF; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.normal.z = std::nanf(""); }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.steps = 6; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.t = -1.0f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.hit.z = 1.1f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.outcome = 7; }));
}

}  // namespace
}  // namespace relievo::viewer
