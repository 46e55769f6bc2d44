#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "surfaces/surface_mesh.h"
#include "textures/depth_map.h"
#include "viewer/camera.h"

namespace relievo::viewer {

/// An object of a frame for the exact reference, which shares no code with what draws it. What it
/// points at must be there while rays are traced.
struct ExactObject {
    const surfaces::SurfaceMesh* mesh = nullptr;
    const textures::DepthMap* relief = nullptr;  ///< null for a plain mesh
    double depthScale = 0.0;                     ///< a, in tile widths
    glm::dvec4 window{0, 0, 1, 1};               ///< minimum u, v, maximum u, v of the relief
};

/// A ray in world space; the direction has unit length.
struct WorldRay {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0, 0, -1};
};

/// Where a ray first meets an object.
struct ExactHit {
    std::size_t object = 0;  ///< its number
    double distance = 0.0;   ///< from the ray's origin
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0, 0, 1};         ///< of the relief there, unit length
    glm::dvec3 surfaceNormal{0, 0, 1};  ///< of the surface that carries it, unit length
};

/// The first hit of `ray` with any of the objects, in double precision. Triangles seen from behind
/// are passed. A relief is searched from every triangle that the ray enters, within its window.
std::optional<ExactHit> firstHit(std::span<const ExactObject> objects, const WorldRay& ray);

/// The ray through the centre of a pixel, rows from the top, from the near plane on.
WorldRay pixelRay(const Camera& camera, int x, int y, int width, int height);

/// The ray that comes through `position` from the near plane.
WorldRay rayThrough(const Camera& camera, const glm::dvec3& position);

/// Whether nothing lies between the near plane and a point, which may be on an object itself.
bool isVisible(std::span<const ExactObject> objects, const Camera& camera,
               const glm::dvec3& position);

/// The window depth of a point, as glDepthRange and glClipControl of the camera's convention have
/// it.
double windowDepth(const Camera& camera, const glm::dvec3& position);

/// What every pixel shows, rows from the top, on all cores.
std::vector<std::optional<ExactHit>> traceScene(std::span<const ExactObject> objects,
                                                const Camera& camera, int width, int height);

}  // namespace relievo::viewer
