#include "hostile_solid_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "shaders/shader_library.h"
#include "tests/gl/full_screen_pass.h"

namespace relievo::viewer {
namespace {

using Share = std::uniform_real_distribution<double>;

constexpr const char* kSearch = R"glsl(
#include "relievo/solid_trace.glsl"

uniform sampler2D originMap;
uniform sampler2D directionMap;

layout(location = RELIEVO_OUTPUT_HIT) out vec4 hitOutput;
layout(location = RELIEVO_OUTPUT_WORK) out vec4 workOutput;
layout(location = RELIEVO_OUTPUT_ORIGIN) out vec4 originOutput;
layout(location = RELIEVO_OUTPUT_DIRECTION) out vec4 directionOutput;
layout(location = RELIEVO_OUTPUT_NORMAL) out vec4 normalOutput;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 origin = texelFetch(originMap, pixel, 0).xyz;
    vec3 direction = texelFetch(directionMap, pixel, 0).xyz;
    // The space of the whole is the world.
    SolidTrace trace = traceSolid(SolidFrame(origin, origin, mat3(1.0)), direction, 0.0);
    hitOutput = vec4(trace.hit.position, trace.hit.t);
    workOutput = vec4(float(trace.hit.outcome), float(trace.hit.steps), float(trace.hit.fetches), 1.0);
    originOutput = vec4(trace.ray.origin, trace.ray.end);
    directionOutput = vec4(trace.ray.direction, 1.0);
    normalOutput = vec4(trace.normal, float(trace.hit.part));
}
)glsl";

// A place near the box, or anywhere in it; one of four times on an eighth of a tile.
glm::dvec3 drawPlace(const glm::dvec3& low, const glm::dvec3& high, double margin,
                     std::mt19937& random) {
    Share share(0.0, 1.0);
    glm::dvec3 place;
    const bool isRound = share(random) < 0.25;
    for (int axis = 0; axis < 3; ++axis) {
        place[axis] = low[axis] - margin + (high[axis] - low[axis] + 2.0 * margin) * share(random);
        if (isRound)
            place[axis] = std::round(8.0 * place[axis]) / 8.0;
    }
    return place;
}

// Evenly in the logarithm of the elevation (degrees), downwards or upwards.
glm::dvec3 drawSlope(double lowest, double highest, std::mt19937& random) {
    Share share(0.0, 1.0);
    const double elevation =
        lowest * std::pow(highest / lowest, share(random)) * std::numbers::pi / 180.0;
    const double azimuth = 2.0 * std::numbers::pi * share(random);
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            (share(random) < 0.5 ? -1.0 : 1.0) * std::sin(elevation)};
}

glm::dvec3 drawAxis(std::mt19937& random) {
    glm::dvec3 direction(0.0);
    direction[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 1.0 : -1.0;
    return direction;
}

constexpr std::string_view kRegimes[] = {"any",      "grazing",       "along an axis",
                                         "level",    "straight",      "from inside",
                                         "far away", "along borders", "short or long"};

HostileSolidRay drawRay(std::size_t regime, const glm::dvec3& low, const glm::dvec3& high,
                        std::mt19937& random) {
    glm::dvec3 origin = drawPlace(low, high, 0.5, random);
    // Towards a place in the box.
    glm::dvec3 direction = drawPlace(low, high, 0.0, random) - origin;
    switch (regime) {
        case 1:
            direction = drawSlope(0.01, 0.1, random);
            break;
        case 2:
            direction = drawAxis(random);
            break;
        case 3:
            direction.z = 0.0;
            if (direction == glm::dvec3(0.0))
                direction = drawAxis(random);
            break;
        case 4:
            direction = {0.0, 0.0, random() % 2 == 0 ? 1.0 : -1.0};
            break;
        case 5:
            origin = drawPlace(low, high, 0.0, random);
            direction = drawSlope(0.01, 90.0, random);
            break;
        case 6:
            origin += 1e5 * glm::dvec3(drawSlope(0.1, 90.0, random));
            direction = drawPlace(low, high, 0.0, random) - origin;
            break;
        case 7:
            origin = glm::round(16.0 * origin) / 16.0;
            direction = random() % 2 == 0 ? drawAxis(random)
                                          : glm::dvec3(random() % 2 == 0 ? 1.0 : -1.0, 1.0, 0.0);
            break;
        case 8:
            direction *= std::pow(10.0, Share(-6.0, 6.0)(random));
            break;
        default:
            break;
    }
    return {glm::vec3(origin), glm::vec3(direction), kRegimes[regime]};
}

gl::Texture uploaded(std::span<const HostileSolidRay> rays, int width, int height,
                     glm::vec3 HostileSolidRay::*member) {
    std::vector<float> values(3 * static_cast<std::size_t>(width) *
                              static_cast<std::size_t>(height));
    for (std::size_t k = 0; k < rays.size(); ++k)
        for (int axis = 0; axis < 3; ++axis)
            values[3 * k + static_cast<std::size_t>(axis)] = (rays[k].*member)[axis];
    gl::Texture texture(width, height, GL_RGB32F);
    texture.upload(values, 3);
    return texture;
}

}  // namespace

std::vector<HostileSolidRay> hostileSolidRays(const glm::dvec3& low, const glm::dvec3& high,
                                              int count) {
    std::mt19937 random(2027);
    std::vector<HostileSolidRay> rays;
    for (int k = 0; k < count; ++k)
        rays.push_back(
            drawRay(static_cast<std::size_t>(k) % std::size(kRegimes), low, high, random));
    return rays;
}

std::vector<HostileSolidRay> absurdSolidRays() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    constexpr float kValues[] = {0.0f,  -0.0f, 1e-38f, 1e-20f, 0.5f,      1.0f,
                                 1e10f, 3e38f, -1e-7f, -1e20f, kInfinity, kNone};
    std::mt19937 random(2028);
    const auto draw = [&] { return kValues[random() % std::size(kValues)]; };
    std::vector<HostileSolidRay> rays;
    for (int k = 0; k < 1024; ++k)
        rays.push_back({{draw(), draw(), draw()}, {draw(), draw(), draw()}, "absurd"});
    return rays;
}

gl::Program solidRayProgram(const materials::SolidMaterial& material,
                            const std::function<std::string(std::string)>& change) {
    std::string text;
    for (const std::string_view file : material.files())
        text += "#include \"" + std::string(file) + "\"\n";
    text += kSearch;
    text = shaders::expandShader("solid rays", text, "#version 450 core", material.defines()).text;
    return gl::tests::fullScreenProgram(change ? change(std::move(text)) : text);
}

std::vector<MeasuredPixel> searchRays(const materials::SolidMaterial& material,
                                      gl::Program& program, std::span<const HostileSolidRay> rays) {
    const int width =
        std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(rays.size())))));
    const int height = (static_cast<int>(rays.size()) + width - 1) / width;
    gl::Framebuffer target = makeMeasuredTarget(width, height);
    const gl::Texture origins = uploaded(rays, width, height, &HostileSolidRay::origin);
    const gl::Texture directions = uploaded(rays, width, height, &HostileSolidRay::direction);
    const GLuint unit = material.bind(program.id());
    program.set("originMap", static_cast<int>(unit));
    program.set("directionMap", static_cast<int>(unit) + 1);
    origins.bind(unit);
    directions.bind(unit + 1);
    gl::tests::drawFullScreen(program, target);
    MeasuredFrame frame = readMeasuredFrame(target);
    // OpenGL counts rows from the bottom.
    std::vector<MeasuredPixel> pixels;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const std::size_t row = k / static_cast<std::size_t>(width);
        const std::size_t column = k % static_cast<std::size_t>(width);
        pixels.push_back(frame.pixels[(static_cast<std::size_t>(height) - 1 - row) *
                                          static_cast<std::size_t>(width) +
                                      column]);
    }
    return pixels;
}

}  // namespace relievo::viewer
