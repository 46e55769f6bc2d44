// The contract between ray set-up, search techniques and shading.
//
// Tile space: (u, v) texture coordinates, one tile = [0,1]², v downwards in the picture; z is the
// normalised depth, 0 on the reference surface and 1 at the bottom. Lengths are measured in the metric
// |(du, ρ·dv, dz)| with ρ = height/width of the map, in which texels are square.
#include "relievo/constants.h"

// More than any length, number of pixels or ratio.
const float kReliefBoundless = 1e30;

struct ReliefRay {
    vec3 origin;      // (u, v, z) where the ray enters the relief
    vec3 direction;   // (du, dv, dz) per unit of t, of length 1 in the metric
    float speed;      // length of the horizontal part, in [0,1]
    float end;        // t at which the ray leaves the window or reaches the bottom
    float worldLength;  // length of one unit of t along the ray, in world units
    float depthScale;   // a: depth of D = 1, in tile widths
    float pixelsPerDepth;  // how many pixels a depth of 1 is long; kReliefBoundless when unknown
};

struct ReliefHit {
    vec3 position;  // (u, v, z)
    float t;        // along the ray
    int outcome;    // RELIEVO_OUTCOME_…
    int steps;      // iterations of the search
    int fetches;    // texture lookups of the search
};

// A point of the surface that carries the relief, in world space.
struct ReliefSurface {
    vec3 position;
    vec3 normal;     // unit length, towards the outside
    vec3 tangent;    // ∂position/∂u: its length is the width of a tile
    vec3 bitangent;  // ∂position/∂v
    vec2 uv;
};

vec3 reliefPoint(ReliefRay ray, float t) { return ray.origin + t * ray.direction; }

// The t in which a ray goes the distance of a depth of 1, whatever its direction; a relief without depth
// has vertical rays, which go it in t = 1.
float reliefDepthLength(ReliefRay ray) {
    float tileLength = length(vec2(ray.speed, ray.depthScale * ray.direction.z));
    return tileLength > 0.0 ? ray.depthScale / tileLength : 1.0;
}

// The cosine of the angle between a ray and the inward normal of the reference surface.
float reliefCosine(ReliefRay ray) { return reliefDepthLength(ray) * ray.direction.z; }

// The dual basis of (tangent, bitangent) within their plane: dot(dualU, tangent) = 1,
// dot(dualU, bitangent) = 0, and the other way round. It serves skewed and mirrored
// parametrisations alike (specification 9, E2).
void reliefDualBasis(ReliefSurface surface, out vec3 dualU, out vec3 dualV) {
    float tt = dot(surface.tangent, surface.tangent);
    float tb = dot(surface.tangent, surface.bitangent);
    float bb = dot(surface.bitangent, surface.bitangent);
    float determinant = max(tt * bb - tb * tb, 1e-30);
    dualU = (bb * surface.tangent - tb * surface.bitangent) / determinant;
    dualV = (tt * surface.bitangent - tb * surface.tangent) / determinant;
}

// The largest t at which origin + t·direction is within [low, high] on one axis.
float reliefAxisExit(float origin, float direction, float low, float high) {
    if (direction > 0.0) return (high - origin) / direction;
    if (direction < 0.0) return (low - origin) / direction;
    return RELIEVO_MAXIMUM_REACH;
}

// A direction of the world in tile space, to be normalised. With w = a·|tangent| it is (d·dualU, d·dualV,
// −d·normal / w), scaled by w, so that a = 0 gives the vertical ray of a flat relief and level rays need
// no division by their vertical speed.
vec3 reliefTileDirection(ReliefSurface surface, vec3 direction, float depthScale) {
    vec3 dualU, dualV;
    reliefDualBasis(surface, dualU, dualV);
    float worldDepth = depthScale * length(surface.tangent);
    return vec3(worldDepth * dot(direction, dualU), worldDepth * dot(direction, dualV),
                -dot(direction, surface.normal));
}

// The t at which a ray of the given speed leaves the window, or the depths from 0 to 1. At most that of
// the longest search.
float reliefRayEnd(vec3 origin, vec3 direction, float speed, vec4 window) {
    float end = speed > 0.0 ? RELIEVO_MAXIMUM_REACH / speed : RELIEVO_MAXIMUM_REACH;
    end = min(end, reliefAxisExit(origin.x, direction.x, window.x, window.z));
    end = min(end, reliefAxisExit(origin.y, direction.y, window.y, window.w));
    end = min(end, reliefAxisExit(origin.z, direction.z, 0.0, 1.0));
    return max(end, 0.0);
}

// The ray through `surface` along `view` (unit length, from the eye into the scene) in tile space.
// depthScale is a, the depth of D = 1 in tile widths; window is (minimum u, v, maximum u, v) of the
// relief; aspect is ρ.
ReliefRay makeReliefRay(ReliefSurface surface, vec3 view, float depthScale, vec4 window,
                        float aspect) {
    vec3 scaled = reliefTileDirection(surface, view, depthScale);
    float norm = length(vec3(scaled.x, aspect * scaled.y, scaled.z));

    ReliefRay ray;
    ray.origin = vec3(surface.uv, 0.0);
    // norm is 0 only for a level ray on a relief without depth: any direction will do.
    ray.direction = norm > 0.0 ? scaled / norm : vec3(0.0, 0.0, 1.0);
    ray.speed = length(vec2(ray.direction.x, aspect * ray.direction.y));
    ray.worldLength = norm > 0.0 ? depthScale * length(surface.tangent) / norm : 0.0;
    ray.depthScale = depthScale;
    ray.pixelsPerDepth = kReliefBoundless;
    ray.end = reliefRayEnd(ray.origin, ray.direction, ray.speed, window);
    return ray;
}
