#include "viewer/exact_scene.h"

#include <tbb/parallel_for.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "reference/bilinear_tracer.h"
#include "shaders/relievo/constants.h"

namespace relievo::viewer {
namespace {

/// A point where a ray enters a triangle from outside.
struct Entry {
    double distance = 0.0;
    glm::dvec3 normal;  ///< unit length
    glm::dvec3 tangent;
    glm::dvec3 bitangent;
    glm::dvec2 uv;
};

using Corners = std::array<const surfaces::SurfaceVertex*, 3>;

// Intersects by barycentric coordinates (Möller, Trumbore 1997), front faces only.
std::optional<Entry> enterTriangle(const Corners& corners, const WorldRay& ray) {
    const glm::dvec3 first(corners[0]->position);
    const glm::dvec3 a = glm::dvec3(corners[1]->position) - first;
    const glm::dvec3 b = glm::dvec3(corners[2]->position) - first;
    const glm::dvec3 p = glm::cross(ray.direction, b);
    const double determinant = glm::dot(a, p);
    if (!(determinant > 0.0))
        return std::nullopt;
    const glm::dvec3 offset = ray.origin - first;
    const glm::dvec3 q = glm::cross(offset, a);
    const glm::dvec2 weight(glm::dot(offset, p) / determinant,
                            glm::dot(ray.direction, q) / determinant);
    const double distance = glm::dot(b, q) / determinant;
    if (weight.x < 0.0 || weight.y < 0.0 || weight.x + weight.y > 1.0 || distance < 0.0)
        return std::nullopt;
    const auto mean = [&](auto member) {
        using Value = decltype(member(*corners[0]));
        return (1.0 - weight.x - weight.y) * Value(member(*corners[0])) +
               weight.x * Value(member(*corners[1])) + weight.y * Value(member(*corners[2]));
    };
    using surfaces::SurfaceVertex;
    Entry entry;
    entry.distance = distance;
    entry.normal =
        glm::normalize(mean([](const SurfaceVertex& v) { return glm::dvec3(v.normal); }));
    entry.tangent = mean([](const SurfaceVertex& v) { return glm::dvec3(v.tangent); });
    entry.bitangent = mean([](const SurfaceVertex& v) { return glm::dvec3(v.bitangent); });
    entry.uv = mean([](const SurfaceVertex& v) { return glm::dvec2(v.uv); });
    return entry;
}

/// A ray in tile space, and the world length of one unit of its t.
struct EnteringRay {
    reference::TileRay ray;
    double worldLength = 0.0;
};

// The directions that the tangents are the gradients of (specification 9, E2), and the depth
// −direction·normal in units of the relief's depth in the world.
EnteringRay intoRelief(const Entry& entry, const glm::dvec3& direction, double depthScale) {
    const double tt = glm::dot(entry.tangent, entry.tangent);
    const double tb = glm::dot(entry.tangent, entry.bitangent);
    const double bb = glm::dot(entry.bitangent, entry.bitangent);
    const double determinant = tt * bb - tb * tb;
    const double alongT = glm::dot(direction, entry.tangent);
    const double alongB = glm::dot(direction, entry.bitangent);
    const double worldDepth = depthScale * glm::length(entry.tangent);
    EnteringRay result;
    result.ray.origin = glm::dvec3(entry.uv, 0.0);
    // Times the depth, so that a relief without depth has vertical rays.
    result.ray.direction = glm::dvec3(worldDepth * (bb * alongT - tb * alongB) / determinant,
                                      worldDepth * (tt * alongB - tb * alongT) / determinant,
                                      -glm::dot(direction, entry.normal));
    result.worldLength = worldDepth;
    return result;
}

std::optional<double> distanceInRelief(const ExactObject& object, const Entry& entry,
                                       const glm::dvec3& direction) {
    if (object.relief == nullptr)
        return entry.distance;
    const EnteringRay entering = intoRelief(entry, direction, object.depthScale);
    const reference::TileWindow window{{object.window.x, object.window.y},
                                       {object.window.z, object.window.w}};
    const auto hit =
        reference::traceBilinear(*object.relief, entering.ray, window, RELIEVO_MAXIMUM_REACH);
    if (!hit)
        return std::nullopt;
    return entry.distance + hit->t * entering.worldLength;
}

// Device depths of the near and the far plane.
glm::dvec2 deviceDepths(const DepthConvention& depth) {
    const double low = depth.zeroToOne ? 0.0 : -1.0;
    return depth.reversed ? glm::dvec2(1.0, low) : glm::dvec2(low, 1.0);
}

// The ray through a point of the device's x and y.
WorldRay deviceRay(const Camera& camera, const glm::dvec2& device) {
    const glm::dmat4 inverse = glm::inverse(glm::dmat4(camera.viewProjection));
    const glm::dvec2 depths = deviceDepths(camera.depth);
    const glm::dvec4 near = inverse * glm::dvec4(device, depths.x, 1.0);
    const glm::dvec4 far = inverse * glm::dvec4(device, depths.y, 1.0);
    const glm::dvec3 origin = glm::dvec3(near) / near.w;
    return {origin, glm::normalize(glm::dvec3(far) / far.w - origin)};
}

}  // namespace

std::optional<ExactHit> firstHit(std::span<const ExactObject> objects, const WorldRay& ray) {
    std::optional<ExactHit> first;
    for (std::size_t number = 0; number < objects.size(); ++number) {
        const surfaces::SurfaceMesh& mesh = *objects[number].mesh;
        for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
            const Corners corners = {&mesh.vertices[mesh.indices[k]],
                                     &mesh.vertices[mesh.indices[k + 1]],
                                     &mesh.vertices[mesh.indices[k + 2]]};
            const auto entry = enterTriangle(corners, ray);
            // The relief lies behind its surface.
            if (!entry || (first && entry->distance >= first->distance))
                continue;
            const auto distance = distanceInRelief(objects[number], *entry, ray.direction);
            if (distance && (!first || *distance < first->distance))
                first = ExactHit{number, *distance, ray.origin + *distance * ray.direction};
        }
    }
    return first;
}

WorldRay pixelRay(const Camera& camera, int x, int y, int width, int height) {
    return deviceRay(camera, {2.0 * (x + 0.5) / width - 1.0, 1.0 - 2.0 * (y + 0.5) / height});
}

WorldRay rayThrough(const Camera& camera, const glm::dvec3& position) {
    const glm::dvec4 clip = glm::dmat4(camera.viewProjection) * glm::dvec4(position, 1.0);
    return deviceRay(camera, {clip.x / clip.w, clip.y / clip.w});
}

double windowDepth(const Camera& camera, const glm::dvec3& position) {
    const glm::dvec4 clip = glm::dmat4(camera.viewProjection) * glm::dvec4(position, 1.0);
    const double device = clip.z / clip.w;
    const double share = camera.depth.zeroToOne ? device : 0.5 * device + 0.5;
    const glm::dvec2 range(camera.depth.range);
    return range.x + share * (range.y - range.x);
}

std::vector<std::optional<ExactHit>> traceScene(std::span<const ExactObject> objects,
                                                const Camera& camera, int width, int height) {
    std::vector<std::optional<ExactHit>> pixels(static_cast<std::size_t>(width) *
                                                static_cast<std::size_t>(height));
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x)
            pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)] =
                firstHit(objects, pixelRay(camera, x, y, width, height));
    });
    return pixels;
}

}  // namespace relievo::viewer
