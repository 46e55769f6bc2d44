// Skewed, stretched and mirrored parametrisations: the hit and its normal in world space, against
// the displaced surface itself in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "bilinear_relief.h"
#include "materials/slope_sources.h"
#include "reference/bilinear_tracer.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "shaders/shader_library.h"
#include "tests/gl/full_screen_pass.h"

namespace relievo::viewer {
namespace {

constexpr int kPixels = 24;
// Differences reach a texel beyond that of the hit; a clamped map goes on differently there.
constexpr double kMargin = 1.6 / 20;

// A plane P(u,v) = origin + u·tangent + v·bitangent that carries the relief, and a direction to
// look along.
struct AffineFrame {
    glm::dvec3 origin;
    glm::dvec3 tangent;
    glm::dvec3 bitangent;
    glm::dvec3 normal;
    glm::dvec3 view;
    double depthScale;

    double worldDepth() const { return depthScale * glm::length(tangent); }
    glm::dvec3 surfaceAt(glm::dvec2 uv) const { return origin + uv.x * tangent + uv.y * bitangent; }
    glm::dvec3 displacedAt(glm::dvec2 uv) const {
        return surfaceAt(uv) - worldDepth() * bilinearDepth(uv) * normal;
    }
};

// Frames of any orientation: tangents of unlike lengths, up to 60° off the right angle, every other
// frame mirrored.
class FrameSource {
  public:
    AffineFrame next() {
        AffineFrame frame;
        frame.normal = direction();
        const glm::dvec3 right = glm::normalize(glm::cross(frame.normal, direction()));
        const glm::dvec3 up = glm::cross(frame.normal, right);
        const double skew = between(-1.05, 1.05);
        frame.tangent = between(0.3, 3.0) * right;
        frame.bitangent = between(0.3, 3.0) * (std::sin(skew) * right + std::cos(skew) * up);
        if (++count_ % 2 == 0)
            frame.bitangent = -frame.bitangent;
        frame.origin = direction();
        frame.depthScale = between(0.02, 0.4);
        frame.view = glm::normalize(-frame.normal + between(0.0, 1.5) * direction());
        if (glm::dot(frame.view, frame.normal) > -0.2)
            frame.view = -frame.normal;
        return frame;
    }

  private:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator_);
    }
    glm::dvec3 direction() {
        std::normal_distribution<double> normal;
        return glm::normalize(
            glm::dvec3(normal(generator_), normal(generator_), normal(generator_)));
    }

    std::mt19937 generator_{41};
    int count_ = 0;
};

constexpr const char* kFragment = R"glsl(
#include "relievo/techniques/pyramid.glsl"
#include "relievo/material.glsl"
in vec2 uv;
uniform vec3 origin;
uniform vec3 tangent;
uniform vec3 bitangent;
uniform vec3 normal;
uniform vec3 view;
layout(location = 0) out vec4 positionOutput;
layout(location = 1) out vec4 normalOutput;
layout(location = 2) out vec4 hitOutput;
void main() {
    ReliefSurface surface = ReliefSurface(origin + uv.x * tangent + uv.y * bitangent, normal,
                                          tangent, bitangent, uv);
    ReliefFragment relief = traceRelief(surface, view);
    positionOutput = vec4(relief.position, float(relief.hit.outcome));
    normalOutput = vec4(relief.normal, 0.0);
    hitOutput = vec4(relief.hit.position, 0.0);
}
)glsl";

struct WorldHit {
    glm::dvec2 start;  // uv where the ray meets the surface
    glm::dvec3 position;
    glm::dvec3 normal;
    glm::dvec2 uv;
};

class AffineFrames : public testing::Test {
  protected:
    // The hits of kPixels² rays of a frame that lie well within the tile.
    static std::vector<WorldHit> trace(const textures::MapSet& maps, const AffineFrame& frame,
                                       materials::SlopeSource source) {
        materials::ReliefMaterial material(std::make_shared<materials::ReliefMaps>(maps, "test"),
                                           materials::findTechnique("pyramid"));
        material.setSlopeSource(source);
        material.depthScale = static_cast<float>(frame.depthScale);
        gl::Program program = gl::tests::fullScreenProgram(
            shaders::expandShader("test", kFragment, "#version 450 core", material.defines()).text);
        program.set("origin", glm::vec3(frame.origin));
        program.set("tangent", glm::vec3(frame.tangent));
        program.set("bitangent", glm::vec3(frame.bitangent));
        program.set("normal", glm::vec3(frame.normal));
        program.set("view", glm::vec3(frame.view));
        material.bind(program.id());
        gl::Framebuffer target(kPixels, kPixels,
                               std::array<GLenum, 3>{GL_RGBA32F, GL_RGBA32F, GL_RGBA32F});
        gl::tests::drawFullScreen(program, target);
        return read(target);
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();

  private:
    static std::vector<WorldHit> read(const gl::Framebuffer& target) {
        const std::array<std::vector<float>, 3> outputs = {target.read(0), target.read(1),
                                                           target.read(2)};
        const auto vector = [&](std::size_t output, std::size_t k) {
            const float* value = &outputs[output][4 * k];
            return glm::dvec3(value[0], value[1], value[2]);
        };
        std::vector<WorldHit> hits;
        for (std::size_t k = 0; k < kPixels * kPixels; ++k) {
            const glm::dvec2 uv(vector(2, k));
            const glm::dvec2 start = (glm::dvec2(k % kPixels, k / kPixels) + 0.5) / double(kPixels);
            if (outputs[0][4 * k + 3] == RELIEVO_OUTCOME_HIT &&
                std::min({uv.x, uv.y, 1.0 - uv.x, 1.0 - uv.y}) > kMargin)
                hits.push_back({start, vector(0, k), vector(1, k), uv});
        }
        return hits;
    }
};

// The normal of the displaced surface by central differences, on the side of the surface's normal.
glm::dvec3 displacedNormal(const AffineFrame& frame, glm::dvec2 uv) {
    constexpr double kStep = 1e-5;
    const glm::dvec3 u =
        frame.displacedAt(uv + glm::dvec2(kStep, 0)) - frame.displacedAt(uv - glm::dvec2(kStep, 0));
    const glm::dvec3 v =
        frame.displacedAt(uv + glm::dvec2(0, kStep)) - frame.displacedAt(uv - glm::dvec2(0, kStep));
    const glm::dvec3 normal = glm::normalize(glm::cross(u, v));
    return glm::dot(normal, frame.normal) < 0.0 ? -normal : normal;
}

// Formula (1.7) of the thesis for depths; as printed, its second factor has Hu and Hv exchanged
// (specification 9, E2).
glm::dvec3 formulaNormal(const AffineFrame& frame, glm::dvec2 uv, bool asPrinted) {
    const glm::dvec2 slope = frame.worldDepth() * bilinearSlope(uv);
    const double tt = glm::dot(frame.tangent, frame.tangent);
    const double tb = glm::dot(frame.tangent, frame.bitangent);
    const double bb = glm::dot(frame.bitangent, frame.bitangent);
    const double first = bb * slope.x - tb * slope.y;
    const double second = asPrinted ? tt * slope.x - tb * slope.y : tt * slope.y - tb * slope.x;
    return glm::normalize(frame.normal +
                          (first * frame.tangent + second * frame.bitangent) / (tt * bb - tb * tb));
}

// The exact position of the hit: the ray in the axes (tangent, bitangent, depth), by the inverse of
// the matrix that they are, through the reference tracer.
glm::dvec3 exactPosition(const AffineFrame& frame, const textures::DepthMap& map,
                         glm::dvec2 start) {
    const glm::dmat3 axes(frame.tangent, frame.bitangent, -frame.worldDepth() * frame.normal);
    const reference::TileRay ray{glm::dvec3(start, 0.0), glm::inverse(axes) * frame.view};
    const auto hit = reference::traceBilinear(map, ray);
    return hit ? frame.surfaceAt(start) + hit->t * frame.view : glm::dvec3(1e9);
}

TEST_F(AffineFrames, HitsLieOnTheDisplacedSurfaceAndHaveItsNormal) {
    struct Size {
        int width;
        int height;
    };
    FrameSource frames;
    std::size_t hits = 0;
    double printedDeviation = 0.0;
    for (const Size size : {Size{64, 64}, Size{64, 24}, Size{20, 64}}) {
        const textures::MapSet maps = bilinearMaps(size.width, size.height);
        const textures::DepthMap map = textures::depthMapOf(maps);
        for (int count = 0; count < 12; ++count) {
            const AffineFrame frame = frames.next();
            const auto source = static_cast<materials::SlopeSource>(count % 3);
            for (const WorldHit& hit : trace(maps, frame, source)) {
                ++hits;
                const glm::dvec3 normal = displacedNormal(frame, hit.uv);
                ASSERT_LT(glm::length(hit.position - exactPosition(frame, map, hit.start)), 2e-5);
                ASSERT_LT(glm::length(hit.position - frame.displacedAt(hit.uv)), 2e-5);
                ASSERT_LT(glm::length(hit.normal - normal), 2e-4);
                ASSERT_LT(glm::length(formulaNormal(frame, hit.uv, false) - normal), 1e-8);
                printedDeviation = std::max(
                    printedDeviation, glm::length(formulaNormal(frame, hit.uv, true) - normal));
            }
        }
    }
    EXPECT_GT(hits, 5000u);
    // The printed formula would not pass.
    EXPECT_GT(printedDeviation, 0.1);
}

}  // namespace
}  // namespace relievo::viewer
