#include "hostile_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "shaders/shader_library.h"
#include "tests/gl/full_screen_pass.h"

namespace relievo::viewer {
namespace {

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

constexpr HostileRegime kRegimes[] = {
    {"any", 0.01, 90.0},
    {"grazing", 0.01, 0.02},
    {.name = "along an axis", .lowest = 0.01, .highest = 90.0, .isAlongAxis = true},
    {"level", 0.0, 0.0},
    {"straight down", 90.0, 90.0},
    {.name = "far away", .lowest = 0.1, .highest = 90.0, .farthest = 1e5},
    {.name = "from inside", .lowest = 0.01, .highest = 90.0, .isInside = true}};

// Where rays begin (u,v,z) and their view directions.
struct HostileRays {
    std::vector<float> places;
    std::vector<float> views;
};

using Share = std::uniform_real_distribution<double>;

// Evenly in the logarithm, so that there are many near the horizon.
double drawElevation(const HostileRegime& regime, std::mt19937& random) {
    if (regime.highest == 0.0)
        return 0.0;
    const double degrees =
        regime.lowest * std::pow(regime.highest / regime.lowest, Share(0.0, 1.0)(random));
    return degrees * std::numbers::pi / 180.0;
}

void drawRay(const HostileRegime& regime, std::mt19937& random, HostileRays& rays) {
    Share share(0.0, 1.0);
    const double elevation = drawElevation(regime, random);
    const double azimuth = regime.isAlongAxis
                               ? std::floor(4.0 * share(random)) * std::numbers::pi / 2.0
                               : 2.0 * std::numbers::pi * share(random);
    // A cosine of a right angle is not quite 0, which would not be along the axis.
    const auto along = [&](double cosine) {
        const double part = std::cos(elevation) * cosine;
        return static_cast<float>(std::abs(part) < 1e-12 ? 0.0 : part);
    };
    for (int axis = 0; axis < 2; ++axis)
        rays.places.push_back(static_cast<float>((2.0 * share(random) - 1.0) * regime.farthest));
    rays.places.push_back(regime.isInside ? static_cast<float>(share(random)) : 0.0f);
    const bool isRising = regime.isInside && share(random) < 0.5;
    const double down = isRising ? std::sin(elevation) : -std::sin(elevation);
    rays.views.insert(rays.views.end(), {along(std::cos(azimuth)), along(std::sin(azimuth)),
                                         static_cast<float>(down)});
}

HostileRays drawRays(int count) {
    std::mt19937 random(2026);
    HostileRays rays;
    for (int k = 0; k < count; ++k)
        drawRay(kRegimes[regimeOfRay(static_cast<std::size_t>(k))], random, rays);
    return rays;
}

// A quad whose every pixel is another ray.
constexpr const char* kRays = R"glsl(
uniform sampler2D placeMap;
uniform sampler2D viewMap;

ReliefSurface hostileSurface(vec2 uv) {
    return ReliefSurface(vec3(0.0), vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0),
                         vec3(0.0, -reliefAspect(), 0.0), uv);
}
)glsl";

// Those that begin below the reference surface are made here: what a renderer calls, traceRelief,
// has them begin on it.
constexpr const char* kSearch = R"glsl(
layout(location = RELIEVO_OUTPUT_HIT) out vec4 hitOutput;
layout(location = RELIEVO_OUTPUT_WORK) out vec4 workOutput;
layout(location = RELIEVO_OUTPUT_ORIGIN) out vec4 originOutput;
layout(location = RELIEVO_OUTPUT_DIRECTION) out vec4 directionOutput;
layout(location = RELIEVO_OUTPUT_NORMAL) out vec4 normalOutput;

ReliefRay insideRay(ReliefSurface surface, vec3 view, float depth) {
    ReliefRay ray = makeReliefRay(surface, view, relievoDepthScale, relievoWindow, reliefAspect());
    ray.origin.z = depth;
    ray.end = reliefRayEnd(ray.origin, ray.direction, ray.speed, relievoWindow);
    return ray;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 place = texelFetch(placeMap, pixel, 0).xyz;
    vec3 view = texelFetch(viewMap, pixel, 0).xyz;
    ReliefSurface surface = hostileSurface(place.xy);
    ReliefFragment relief;
    if (place.z > 0.0) {
        relief.ray = insideRay(surface, view, place.z);
        relief.hit = searchRelief(relief.ray);
        if (!reliefInWindow(relief.hit.position.xy)) relief.hit.outcome = RELIEVO_OUTCOME_MISS;
        relief.tileNormal = vec3(0.0, 0.0, 1.0);
    } else {
        // Neighbouring pixels are other rays: they say nothing of the size of a pixel. In the least of
        // them there is nothing too small to be searched.
        relief = traceRelief(surface, view, ReliefFootprint(0.0, 0.0, 0.5));
    }
    hitOutput = vec4(relief.hit.position, relief.hit.t);
    workOutput = vec4(float(relief.hit.outcome), float(relief.hit.steps),
                      float(relief.hit.fetches), 1.0);
    originOutput = vec4(relief.ray.origin, relief.ray.end);
    directionOutput = vec4(relief.ray.direction, relief.ray.worldLength);
    normalOutput = vec4(relief.tileNormal, 0.0);
}
)glsl";

constexpr const char* kLight = R"glsl(
uniform float lightRadius;
layout(location = RELIEVO_OUTPUT_WORK) out vec4 workOutput;
layout(location = RELIEVO_OUTPUT_ORIGIN) out vec4 originOutput;
layout(location = RELIEVO_OUTPUT_LIGHT) out vec4 lightOutput;
layout(location = RELIEVO_OUTPUT_LIFT) out vec4 liftOutput;
layout(location = RELIEVO_OUTPUT_SIDE) out vec4 sideOutput;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 place = texelFetch(placeMap, pixel, 0).xyz;
    vec3 toLight = -texelFetch(viewMap, pixel, 0).xyz;
    ReliefLight light =
        makeReliefLight(hostileSurface(place.xy), place, toLight, lightRadius);
    float share = reliefVisibility(light);
    workOutput = vec4(0.0, 0.0, 0.0, 1.0);
    originOutput = vec4(place, 0.0);
    lightOutput = vec4(light.direction, share);
    liftOutput = vec4(light.lift, float(reliefFetchCount));
    sideOutput = vec4(light.side, 0.0);
}
)glsl";

gl::Program programOf(const materials::ReliefMaterial& material,
                      const std::vector<std::string_view>& files, const char* body) {
    std::string text;
    for (const std::string_view file : files)
        text += "#include \"" + std::string(file) + "\"\n";
    text += kRays;
    text += body;
    return gl::tests::fullScreenProgram(
        shaders::expandShader("hostile rays", text, "#version 450 core", material.defines()).text);
}

gl::Texture uploaded(const std::vector<float>& values, int size) {
    gl::Texture texture(size, size, GL_RGB32F);
    texture.upload(values, 3);
    return texture;
}

}  // namespace

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
            {"64 to 1", noiseMap(128, 2, WrapMode::Repeat)},
            {"noise", noiseMap(17, 11, WrapMode::Mirror), ConeEncoding::Radius},
            {"binary", binaryMap()},
            {"binary by radius", binaryMap(), ConeEncoding::Radius},
            {"lone spike", loneSpike()}};
}

std::span<const HostileRegime> hostileRegimes() {
    return kRegimes;
}

std::size_t regimeOfRay(std::size_t ray) {
    return ray % std::size(kRegimes);
}

HostileFrame::HostileFrame(int size) : target_(makeMeasuredTarget(size, size)) {
    const HostileRays rays = drawRays(size * size);
    places_ = uploaded(rays.places, size);
    views_ = uploaded(rays.views, size);
}

MeasuredFrame HostileFrame::search(const materials::ReliefMaterial& material,
                                   gl::Program& program) {
    return draw(program, material.bind(program.id()));
}

MeasuredFrame HostileFrame::light(const materials::ReliefMaterial& material, gl::Program& program,
                                  float radius) {
    program.set("lightRadius", radius);
    return draw(program, material.bindSearch(program.id()));
}

MeasuredFrame HostileFrame::draw(gl::Program& program, GLuint unit) {
    program.set("placeMap", static_cast<int>(unit));
    program.set("viewMap", static_cast<int>(unit) + 1);
    places_.bind(unit);
    views_.bind(unit + 1);
    gl::tests::drawFullScreen(program, target_);
    MeasuredFrame frame = readMeasuredFrame(target_);
    // OpenGL counts rows from the bottom: now pixels are numbered like rays.
    for (int y = 0; y < frame.height / 2; ++y)
        std::swap_ranges(frame.pixels.begin() + y * frame.width,
                         frame.pixels.begin() + (y + 1) * frame.width,
                         frame.pixels.begin() + (frame.height - 1 - y) * frame.width);
    return frame;
}

gl::Program hostileProgram(const materials::ReliefMaterial& material) {
    return programOf(material, {material.technique().file, "relievo/material.glsl"}, kSearch);
}

gl::Program hostileLightProgram(const materials::ReliefMaterial& material) {
    return programOf(material, material.files(), kLight);
}

}  // namespace relievo::viewer
