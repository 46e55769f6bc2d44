// The contract between shading and the methods of self-shadowing: how a light stands over a point of the
// relief, and how much of it gets there.
//
// A fragment shader includes one file of techniques/, then one of shadows/, which defines
//
//   float reliefVisibility(ReliefLight light);
//
// the share of the light that gets to its point, 0 to 1. What stands below the reference surface, of
// the light, never does.
#include "relievo/disc.glsl"
#include "relievo/material.glsl"

// A light far away, seen as a disc. Directions are those of tile space, all scaled alike.
struct ReliefLight {
    vec3 point;      // (u, v, z) of the point that is lit
    vec3 direction;  // towards the centre of the light, of length 1 in the metric; z < 0 is up
    vec3 lift;       // from there to the edge of the disc that is highest above the surface
    vec3 side;       // likewise at right angles to it; both are 0 for a light that is a point
};

// `toLight` has unit length; `radius` is what the light spans to each side, in radians.
ReliefLight makeReliefLight(ReliefSurface surface, vec3 point, vec3 toLight, float radius) {
    vec3 side = cross(surface.normal, toLight);
    // Of a light straight above no edge is higher than others, and rounding would choose one.
    if (dot(side, side) < 1e-6) side = surface.bitangent;
    side = normalize(side);
    float spread = tan(radius);
    vec3 direction = reliefTileDirection(surface, toLight, relievoDepthScale);
    float norm = length(vec3(direction.x, reliefAspect() * direction.y, direction.z));
    // It is 0 only for level light on a relief without depth.
    float scale = norm > 0.0 ? 1.0 / norm : 0.0;
    vec3 lift = reliefTileDirection(surface, spread * cross(toLight, side), relievoDepthScale);
    side = reliefTileDirection(surface, spread * side, relievoDepthScale);
    return ReliefLight(point, scale * direction, scale * lift, scale * side);
}
