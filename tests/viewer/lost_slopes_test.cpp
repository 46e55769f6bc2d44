// What a MIP level has averaged away is still in its shading: the mean over a tile is that of the
// relief itself, in double precision, at whatever level it is drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "bench/technique_maps.h"
#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "relief_scene.h"
#include "surfaces/surface_mesh.h"
#include "viewer/temporal_error.h"

namespace relievo::viewer {
namespace {

constexpr int kSize = 256;  // texels of a tile along each side
constexpr float kDepthScale = 0.1f;
const glm::vec3 kToLight = directionTowards(-50.0f, 40.0f);

// A relief of which depth and slopes are known everywhere: (D, ∂D/∂u, ∂D/∂v) at (u,v), with
// period 1.
using ClosedForm = std::function<glm::dvec3(double, double)>;

// Many waves of random phases and directions: slopes of two axes are all but Gaussian.
ClosedForm gaussianSlopes(double deviation) {
    struct Wave {
        double u, v, phase;
    };
    std::mt19937 generator(11);
    std::vector<Wave> waves;
    double squares = 0.0;
    while (waves.size() < 48) {
        const double u = static_cast<double>(generator() % 17) - 8.0;
        const double v = static_cast<double>(generator() % 17) - 8.0;
        const double length = std::hypot(u, v);
        if (length < 4.0 || length > 8.0)
            continue;
        waves.push_back({2.0 * std::numbers::pi * u, 2.0 * std::numbers::pi * v,
                         2.0 * std::numbers::pi * static_cast<double>(generator()) / 4294967296.0});
        squares += 0.25 * (waves.back().u * waves.back().u + waves.back().v * waves.back().v);
    }
    const double amplitude = deviation / (static_cast<double>(kDepthScale) * std::sqrt(squares));
    return [=](double u, double v) {
        glm::dvec3 sum(0.5, 0.0, 0.0);
        for (const Wave& wave : waves) {
            const double angle = wave.u * u + wave.v * v + wave.phase;
            sum.x += amplitude * std::sin(angle);
            sum.y += amplitude * wave.u * std::cos(angle);
            sum.z += amplitude * wave.v * std::cos(angle);
        }
        return sum;
    };
}

// Grooves of straight sides, so many along u and along v: two slopes only.
ClosedForm sawTooth(int alongU, int alongV, double slope) {
    const double length = std::hypot(alongU, alongV);
    const double rise = slope / (static_cast<double>(kDepthScale) * length);
    return [=](double u, double v) {
        const double place = alongU * u + alongV * v;
        const double fraction = place - std::floor(place);
        const double sign = fraction < 0.5 ? 1.0 : -1.0;
        return glm::dvec3(rise * std::min(fraction, 1.0 - fraction), sign * rise * alongU,
                          sign * rise * alongV);
    };
}

textures::DepthMap sampled(const ClosedForm& relief, textures::WrapMode wrap) {
    textures::DepthMap map{textures::Plane(kSize, kSize), wrap};
    for (int j = 0; j < kSize; ++j)
        for (int i = 0; i < kSize; ++i)
            map.depth.at(i, j) = static_cast<float>(relief((i + 0.5) / kSize, (j + 0.5) / kSize).x);
    return map;
}

// Azimuth and elevation of the eye, in degrees.
struct Seen {
    float azimuth, elevation;
};
constexpr Seen kViews[] = {{0.0f, 90.0f}, {30.0f, 55.0f}, {130.0f, 55.0f}};

// shading/blinn_phong.glsl in double precision, of the usual grey.
double shade(const glm::dvec3& normal, const Seen& from) {
    const glm::dvec3 toLight(kToLight);
    const glm::dvec3 toEye(directionTowards(from.azimuth, from.elevation));
    const glm::dvec3 weights(0.2126, 0.7152, 0.0722);
    const double sky = glm::dot(weights, glm::dvec3(0.20, 0.215, 0.245));
    const double ground = glm::dot(weights, glm::dvec3(0.12, 0.115, 0.11));
    const double ambient = ground + (0.5 + 0.5 * normal.z) * (sky - ground);
    const double diffuse = std::max(glm::dot(normal, toLight), 0.0);
    const double facing = std::max(glm::dot(normal, glm::normalize(toLight + toEye)), 0.0);
    return 0.6 * (ambient + diffuse) + (diffuse > 0.0 ? 0.12 * std::pow(facing, 32.0) : 0.0);
}

// The mean of what is seen of a tile, of which no part hides another. Mirrored tiles have u
// reversed.
double trueMean(const ClosedForm& relief, bool mirrored, const Seen& from) {
    const glm::dvec3 toEye(directionTowards(from.azimuth, from.elevation));
    constexpr int kSamples = 512;
    double sum = 0.0;
    double seen = 0.0;
    for (int j = 0; j < kSamples; ++j)
        for (int i = 0; i < kSamples; ++i) {
            const glm::dvec3 at = relief((i + 0.5) / kSamples, (j + 0.5) / kSamples);
            const double a = static_cast<double>(kDepthScale);
            const glm::dvec3 upright((mirrored ? -a : a) * at.y, -a * at.z, 1.0);
            const double share = glm::dot(upright, toEye);
            EXPECT_GT(share, 0.0);
            sum += share * shade(glm::normalize(upright), from);
            seen += share;
        }
    return sum / seen;
}

class LostSlopes : public testing::Test {
  protected:
    static View viewFrom(const Seen& from) {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        View view;
        view.camera = parallelRays(from.azimuth, from.elevation, 1.0f);
        view.toLight = kToLight;
        view.depthScale = kDepthScale;
        view.window = {-kInfinity, -kInfinity, kInfinity, kInfinity};
        return view;
    }

    // The mean luminance of a tile drawn at one level: of the first tile, or one to the right of
    // it.
    static double drawnMean(SceneRenderer& renderer, const View& view, int level, int tile = 0) {
        surfaces::SurfaceMesh quad = surfaces::makeQuad({1, 1}, 1.0f);
        for (auto& vertex : quad.vertices)
            vertex.uv.x += static_cast<float>(tile);
        renderer.setSurface(quad);
        materials::ReliefMaterial material =
            renderer.makeMaterial(materials::findTechnique("relief"));
        material.levels = glm::vec2(static_cast<float>(level));
        gl::Framebuffer target(64, 64, std::array<GLenum, 1>{GL_RGBA32F});
        renderer.draw(material, view, target);
        const std::vector<float> pixels = target.read(0);
        double sum = 0.0;
        for (std::size_t k = 0; k < pixels.size(); k += 4)
            sum += luminance(&pixels[k]);
        return 4.0 * sum / static_cast<double>(pixels.size());
    }

    static SceneRenderer makeRenderer(const ClosedForm& relief, textures::WrapMode wrap) {
        preprocess::ReliefPlan plan = bench::planFor(materials::findTechnique("relief"));
        plan.mips = true;
        return SceneRenderer(preprocess::bakeLevels(sampled(relief, wrap), plan), "test", {});
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

// Four slopes stand for all: exact would be as many as there are, which for a saw-tooth is two.
TEST_F(LostSlopes, KeepTheMeanOfClosedFormsInEveryLevel) {
    const struct {
        const char* name;
        ClosedForm relief;
        double bound;
    } kReliefs[] = {{"Gaussian, 0.2", gaussianSlopes(0.2), 0.0056},
                    {"Gaussian, 0.3", gaussianSlopes(0.3), 0.0085},
                    {"saw-tooth across", sawTooth(4, 0, 0.6), 0.042},
                    {"saw-tooth down", sawTooth(0, 4, 0.6), 0.042},
                    {"saw-tooth askew", sawTooth(3, 3, 0.6), 0.03}};
    for (const auto& [name, relief, bound] : kReliefs) {
        SceneRenderer renderer = makeRenderer(relief, textures::WrapMode::Repeat);
        double ignored = 0.0;
        for (const Seen& from : kViews) {
            const double truth = trueMean(relief, false, from);
            ignored = std::max(ignored, std::abs(shade({0, 0, 1}, from) - truth));
            for (const int level : {1, 2, 3, 4, 5, 6, 8}) {
                const double mean = drawnMean(renderer, viewFrom(from), level);
                EXPECT_NEAR(mean, truth, bound) << name << ", level " << level << ", from "
                                                << from.azimuth << ", " << from.elevation;
            }
        }
        // The wrong variant, which shades the mean slope, that of the plane.
        EXPECT_GT(ignored, 4.0 * bound) << name;
    }
}

// In the tile beside a mirrored one grooves run the other way.
TEST_F(LostSlopes, AreMirroredWithTheTile) {
    const ClosedForm relief = sawTooth(3, 3, 0.6);
    SceneRenderer renderer = makeRenderer(relief, textures::WrapMode::Mirror);
    const Seen& from = kViews[2];
    const double mirrored = trueMean(relief, true, from);
    const double straight = trueMean(relief, false, from);
    EXPECT_GT(std::abs(mirrored - straight), 0.09);
    for (const int level : {3, 5}) {
        EXPECT_NEAR(drawnMean(renderer, viewFrom(from), level, 1), mirrored, 0.03) << level;
        EXPECT_NEAR(drawnMean(renderer, viewFrom(from), level), straight, 0.03) << level;
    }
}

// Grooves end at the border of a clamped tile, beyond which the relief is level.
TEST_F(LostSlopes, EndWithAClampedTile) {
    const ClosedForm relief = sawTooth(4, 0, 0.6);
    SceneRenderer renderer = makeRenderer(relief, textures::WrapMode::Clamp);
    const Seen& from = kViews[2];
    const double level = shade({0, 0, 1}, from);
    EXPECT_NEAR(drawnMean(renderer, viewFrom(from), 2, 1), level, 0.01);
    EXPECT_GT(std::abs(trueMean(relief, false, from) - level), 0.1);
}

// What a metal mirrors is spread as wide as its lost slopes, whatever the roughness of its own. The
// truth is the first level, where every ray has one normal and the lobe of the metal.
TEST_F(LostSlopes, WidenTheLobesOfMetals) {
    SceneRenderer renderer = makeRenderer(gaussianSlopes(0.3), textures::WrapMode::Repeat);
    for (const float roughness : {0.65f, 0.75f})
        for (const Seen& from : {Seen{130.0f, 40.0f}, Seen{130.0f, 65.0f}}) {
            View view = viewFrom(from);
            view.shading.model = materials::ShadingModel::Microfacet;
            view.shading.metalness = 1.0f;
            view.shading.roughness = roughness;
            const double truth = drawnMean(renderer, view, 0);
            View flat = view;
            flat.depthScale = 0.0f;
            // The wrong variant, lobes that are not widened: a plane in place of the bumps.
            const double ignored = drawnMean(renderer, flat, 0) - truth;
            EXPECT_GT(ignored, 0.1);
            for (const int level : {3, 4, 5, 6, 8})
                EXPECT_NEAR(drawnMean(renderer, view, level), truth, 0.35 * ignored)
                    << "roughness " << roughness << ", level " << level << ", from "
                    << from.elevation;
        }
}

}  // namespace
}  // namespace relievo::viewer
