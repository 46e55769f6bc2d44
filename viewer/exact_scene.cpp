#include "viewer/exact_scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// The vectors whose products with a direction along the surface are its du and dv
/// (specification 9, E2).
struct DualBasis {
    glm::dvec3 u;
    glm::dvec3 v;
};

DualBasis dualBasis(const Entry& entry) {
    const double tt = glm::dot(entry.tangent, entry.tangent);
    const double tb = glm::dot(entry.tangent, entry.bitangent);
    const double bb = glm::dot(entry.bitangent, entry.bitangent);
    const double determinant = tt * bb - tb * tb;
    return {(bb * entry.tangent - tb * entry.bitangent) / determinant,
            (tt * entry.bitangent - tb * entry.tangent) / determinant};
}

/// A hit as far as one triangle knows of it.
struct Hit {
    double distance = 0.0;
    glm::dvec3 normal;
};

// The tile ray is scaled by the depth of the relief in the world, so that one without depth has
// vertical rays and t counts world lengths over that depth.
std::optional<Hit> hitBehind(const Entry& entry, const ExactObject& object,
                             const glm::dvec3& direction) {
    if (object.relief == nullptr)
        return Hit{entry.distance, entry.normal};
    const DualBasis dual = dualBasis(entry);
    const double tile = glm::length(entry.tangent);
    const double depth = object.depthScale * tile;
    const reference::TileRay ray{
        {entry.uv, 0.0},
        {depth * glm::dot(direction, dual.u), depth * glm::dot(direction, dual.v),
         -glm::dot(direction, entry.normal)}};
    const reference::TileWindow window{{object.window.x, object.window.y},
                                       {object.window.z, object.window.w}};
    const auto hit = reference::traceBilinear(*object.relief, ray, window, RELIEVO_MAXIMUM_REACH);
    if (!hit)
        return std::nullopt;
    // In the tile's metric: slopes a·∂D/∂u and a·∂D/∂v over ρ.
    const glm::dvec3 normal = reference::bilinearNormal(*object.relief, hit->position.x,
                                                        hit->position.y, object.depthScale);
    return Hit{
        entry.distance + hit->t * depth,
        glm::normalize(normal.z * entry.normal +
                       tile * (normal.x * dual.u + object.relief->aspect() * normal.y * dual.v))};
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
            const auto hit = hitBehind(*entry, objects[number], ray.direction);
            if (hit && (!first || hit->distance < first->distance))
                first = ExactHit{number, hit->distance, ray.origin + hit->distance * ray.direction,
                                 hit->normal, entry->normal};
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

bool isVisible(std::span<const ExactObject> objects, const Camera& camera,
               const glm::dvec3& position) {
    const WorldRay ray = rayThrough(camera, position);
    const double distance = glm::dot(position - ray.origin, ray.direction);
    const auto first = firstHit(objects, ray);
    // The point itself is found again but for rounding.
    return !first || first->distance >= distance - 1e-9 * std::max(1.0, std::abs(distance));
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
