// The CPU's sampling (textures/bilinear.h) against OpenGL's, so that what the maps promise on one
// side holds on the other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "full_screen_pass.h"
#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "textures/bilinear.h"

namespace relievo::gl {
namespace {

using textures::Plane;
using textures::WrapMode;

constexpr int kSide = 100;  // kSide² lookups in one frame
constexpr std::array kWrapModes = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr std::array<std::array<int, 2>, 8> kSizes = {
    {{1, 1}, {1, 7}, {7, 1}, {2, 2}, {13, 5}, {16, 16}, {31, 64}, {97, 3}}};

struct Lookup {
    float u;
    float v;
};

/// A CPU sampler: what it returns at (u,v).
using Sampler = std::function<double(const Plane&, double, double, WrapMode)>;

GLenum glWrap(WrapMode wrap) {
    switch (wrap) {
        case WrapMode::Repeat:
            return GL_REPEAT;
        case WrapMode::Mirror:
            return GL_MIRRORED_REPEAT;
        case WrapMode::Clamp:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

Plane randomPlane(int width, int height, std::mt19937& random) {
    Plane plane(width, height);
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    for (float& texel : plane.texels)
        texel = value(random);
    return plane;
}

/// uv in [-4,5] as multiples of 2^-14: times the sizes above they are exact in float, so that the
/// GPU samples at the very place at which the CPU does, at borders between texels as well.
std::vector<Lookup> exactLookups(std::mt19937& random) {
    std::uniform_int_distribution<int> step(-4 * 16384, 5 * 16384);
    std::vector<Lookup> lookups(kSide * kSide);
    for (Lookup& lookup : lookups)
        lookup = {static_cast<float>(step(random)) / 16384.0f,
                  static_cast<float>(step(random)) / 16384.0f};
    // The corners and the middle of the tile, where rules of rounding show.
    lookups[0] = {0.0f, 0.0f};
    lookups[1] = {1.0f, 1.0f};
    lookups[2] = {0.5f, 0.5f};
    lookups[3] = {-1.0f, 2.0f};
    return lookups;
}

std::vector<Lookup> anyLookups(float low, float high, std::mt19937& random) {
    std::uniform_real_distribution<float> coordinate(low, high);
    std::vector<Lookup> lookups(kSide * kSide);
    for (Lookup& lookup : lookups)
        lookup = {coordinate(random), coordinate(random)};
    return lookups;
}

class Sampling : public ::testing::TestWithParam<Backend> {
  protected:
    /// What the GPU's texture unit returns for each lookup.
    std::vector<float> sampleOnGpu(const Plane& plane, const std::vector<Lookup>& lookups,
                                   WrapMode wrap, GLenum filter) {
        Texture map(plane.width, plane.height, GL_R32F);
        map.upload(plane.texels, 1);
        map.setSampling(glWrap(wrap), filter);
        std::vector<float> coordinates;
        for (const Lookup& lookup : lookups) {
            coordinates.push_back(lookup.u);
            coordinates.push_back(lookup.v);
        }
        Texture places(kSide, kSide, GL_RG32F);
        places.upload(coordinates, 2);
        map.bind(0);
        places.bind(1);
        program_.set("map", 0);
        program_.set("places", 1);
        tests::drawFullScreen(program_, target_);
        const std::vector<float> pixels = target_.read(0);
        std::vector<float> values;
        for (std::size_t i = 0; i < pixels.size(); i += 4)
            values.push_back(pixels[i]);
        return values;
    }

    std::mt19937 random_{20090615};

  private:
    static constexpr std::array<GLenum, 1> kFormat = {GL_RGBA32F};

    std::unique_ptr<Context> context_ = createContext(GetParam(), {.debug = true});
    Framebuffer target_{kSide, kSide, kFormat};
    Program program_ = tests::fullScreenProgram(R"(#version 450 core
out vec4 color;
uniform sampler2D map;
uniform sampler2D places;
void main() {
    // Texel (i,j) was uploaded row by row from the top, as the pixels are read.
    ivec2 texel = ivec2(gl_FragCoord.xy);
    texel.y = textureSize(places, 0).y - 1 - texel.y;
    color = vec4(texture(map, texelFetch(places, texel, 0).xy).r);
}
)");
};

/// How many lookups differ by more than the tolerance.
int mismatches(const std::vector<float>& gpu, const Plane& plane,
               const std::vector<Lookup>& lookups, WrapMode wrap, const Sampler& sampler,
               double tolerance = 1e-6) {
    int count = 0;
    for (std::size_t i = 0; i < lookups.size(); ++i)
        if (!(std::abs(gpu[i] - sampler(plane, lookups[i].u, lookups[i].v, wrap)) <= tolerance))
            ++count;
    return count;
}

TEST_P(Sampling, LinearEqualsTheCpuEverywhere) {
    for (const WrapMode wrap : kWrapModes)
        for (const auto& [width, height] : kSizes) {
            SCOPED_TRACE(fmt::format("{} {} x {}", wrapModeName(wrap), width, height));
            const Plane plane = randomPlane(width, height, random_);
            const std::vector<Lookup> lookups = exactLookups(random_);
            const std::vector<float> gpu = sampleOnGpu(plane, lookups, wrap, GL_LINEAR);
            EXPECT_EQ(mismatches(gpu, plane, lookups, wrap, textures::sampleBilinear), 0);
        }
}

/// Whether `value` is the nearest texel at the lookup, or at a place within `reach` of it.
bool isNearest(float value, const Plane& plane, const Lookup& lookup, WrapMode wrap, double reachU,
               double reachV) {
    for (const double du : {-reachU, 0.0, reachU})
        for (const double dv : {-reachV, 0.0, reachV})
            if (value == textures::sampleNearest(plane, lookup.u + du, lookup.v + dv, wrap))
                return true;
    return false;
}

/// Far more than the rounding of u·width, far less than a texel.
constexpr double kReach = 5e-7;

/// Mesa mirrors the coordinate and then takes the texel, OpenGL's specification has it the other
/// way round: in mirrored tiles a place exactly on a border belongs to the texel on its other side.
double borderReach(double coordinate, int size, WrapMode wrap) {
    const double texels = coordinate * size;
    return wrap == WrapMode::Mirror && texels == std::floor(texels) ? kReach : 0.0;
}

TEST_P(Sampling, NearestEqualsTheCpuEverywhere) {
    for (const WrapMode wrap : kWrapModes)
        for (const auto& [width, height] : kSizes) {
            SCOPED_TRACE(fmt::format("{} {} x {}", wrapModeName(wrap), width, height));
            const Plane plane = randomPlane(width, height, random_);
            const std::vector<Lookup> lookups = exactLookups(random_);
            const std::vector<float> gpu = sampleOnGpu(plane, lookups, wrap, GL_NEAREST);
            int wrong = 0;
            for (std::size_t i = 0; i < lookups.size(); ++i)
                if (!isNearest(gpu[i], plane, lookups[i], wrap,
                               borderReach(lookups[i].u, width, wrap),
                               borderReach(lookups[i].v, height, wrap)))
                    ++wrong;
            EXPECT_EQ(wrong, 0);
        }
}

TEST_P(Sampling, LinearEqualsTheCpuAtAnyFloatUpToItsRounding) {
    for (const WrapMode wrap : kWrapModes)
        for (const auto& [width, height] : kSizes) {
            SCOPED_TRACE(fmt::format("{} {} x {}", wrapModeName(wrap), width, height));
            const Plane plane = randomPlane(width, height, random_);
            const std::vector<Lookup> lookups = anyLookups(-4.0f, 5.0f, random_);
            const std::vector<float> gpu = sampleOnGpu(plane, lookups, wrap, GL_LINEAR);
            // u·width is rounded to float, by up to 2^-24 of it and twice (scale, less ½), and
            // neighbours differ by up to 1.
            const double rounding = 2.0 * std::ldexp(5.0 * (width + height), -24);
            EXPECT_EQ(
                mismatches(gpu, plane, lookups, wrap, textures::sampleBilinear, 1e-6 + rounding),
                0);
        }
}

TEST_P(Sampling, NearestEqualsTheCpuAtAnyFloatUpToItsRounding) {
    for (const WrapMode wrap : kWrapModes)
        for (const auto& [width, height] : kSizes) {
            SCOPED_TRACE(fmt::format("{} {} x {}", wrapModeName(wrap), width, height));
            const Plane plane = randomPlane(width, height, random_);
            const std::vector<Lookup> lookups = anyLookups(-4.0f, 5.0f, random_);
            const std::vector<float> gpu = sampleOnGpu(plane, lookups, wrap, GL_NEAREST);
            int wrong = 0;
            // Within the rounding of u·width a lookup on a border may fall on either side.
            for (std::size_t i = 0; i < lookups.size(); ++i)
                if (!isNearest(gpu[i], plane, lookups[i], wrap, kReach, kReach))
                    ++wrong;
            EXPECT_EQ(wrong, 0);
        }
}

TEST_P(Sampling, WrongSamplersAreFound) {
    const Plane plane = randomPlane(13, 5, random_);
    const std::vector<Lookup> lookups = exactLookups(random_);
    const Sampler halfTexelOff = [](const Plane& p, double u, double v, WrapMode wrap) {
        return textures::sampleBilinear(p, u + 0.5 / p.width, v + 0.5 / p.height, wrap);
    };
    const Sampler upsideDown = [](const Plane& p, double u, double v, WrapMode wrap) {
        return textures::sampleBilinear(p, u, 1.0 - v, wrap);
    };
    for (const WrapMode wrap : kWrapModes) {
        SCOPED_TRACE(wrapModeName(wrap));
        const std::vector<float> gpu = sampleOnGpu(plane, lookups, wrap, GL_LINEAR);
        EXPECT_GT(mismatches(gpu, plane, lookups, wrap, halfTexelOff), 100);
        EXPECT_GT(mismatches(gpu, plane, lookups, wrap, upsideDown), 100);
        EXPECT_GT(mismatches(gpu, plane, lookups, wrap, textures::sampleNearest), 100);
        const std::vector<float> nearest = sampleOnGpu(plane, lookups, wrap, GL_NEAREST);
        const Sampler halfTexelOffNearest = [](const Plane& p, double u, double v, WrapMode w) {
            return textures::sampleNearest(p, u + 0.5 / p.width, v, w);
        };
        EXPECT_GT(mismatches(nearest, plane, lookups, wrap, halfTexelOffNearest), 100);
        for (const WrapMode other : kWrapModes)
            if (other != wrap) {
                EXPECT_GT(mismatches(gpu, plane, lookups, other, textures::sampleBilinear), 100);
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Windowless, Sampling, ::testing::Values(Backend::OSMesa, Backend::Egl),
                         [](const auto& test) { return std::string(backendName(test.param)); });

}  // namespace
}  // namespace relievo::gl
