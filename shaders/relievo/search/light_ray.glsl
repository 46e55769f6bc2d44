// Whether light gets to a point of the relief, by the technique that found the point (Policarpo, Oliveira,
// Comba 2005): the light ray is searched downwards, from where it enters the relief, so that all maps keep
// their promises.
//
// No bias is needed for the ray not to be stopped by the surface that it ends on. The point is put on the
// surface, in the cell that holds it, and the ray is followed upwards from there in closed form, cell by
// cell, until it is so high above the surface that the technique cannot take the point for a hit. The
// search ends there.
#include "relievo/light.glsl"
#include "relievo/search/cells.glsl"

// How far above the surface a technique takes a point for a hit, in a cell whose corners differ by `rise`
// in depth. One that does so defines it.
#ifndef RELIEVO_SEARCH_TOLERANCE
#define RELIEVO_SEARCH_TOLERANCE(rise) 0.0
#endif

// What floats do to depths of up to 1 in a few operations; and more than what reliefAtEnd takes for the
// bottom.
const float kReliefDepthRounding = 1.0 / 524288.0;

// How far above the surface a ray must be for a search to be sure of it, in a cell whose corners differ by
// `rise` in depth: texture units resolve 1/256 of a texel, and floats place a ray that goes from
// `origin` over the map with 2⁻²² of its coordinates.
float reliefClearance(ReliefRay ray, float rise) {
    vec2 farthest = max(abs(ray.origin.xy), abs(reliefPoint(ray, ray.end).xy));
    vec2 texels = vec2(reliefMapSize()) * farthest / 4194304.0;
    return RELIEVO_SEARCH_TOLERANCE(rise) + kReliefDepthRounding +
           rise * (1.0 / 256.0 + texels.x + texels.y);
}

// The most that a ray is below the surface in the first `span` of t in a cell.
float reliefDeepest(vec3 below, float span) {
    float deepest = max(below.x, below.x + (below.y + below.z * span) * span);
    float vertex = below.z < 0.0 ? -0.5 * below.y / below.z : 0.0;
    if (vertex > 0.0 && vertex < span) deepest = max(deepest, below.x + 0.5 * below.y * vertex);
    return deepest;
}

// Follows a ray that begins on the surface until it is clear of it, at t, or leaves the relief. False when
// it gets below the surface before. One that is not clear after as many cells as the tile has along both
// sides counts as one that leaves: it stays so near to the surface that a search would hit it anywhere.
bool reliefIsClear(ReliefRay ray, out float t) {
    ReliefWalk walk = reliefBeginWalk(ray);
    ivec2 size = reliefMapSize();
    t = 0.0;
    for (int cells = size.x + size.y; cells > 0; --cells) {
        vec4 corners = reliefWalkCorners(walk);
        vec3 profile = reliefProfile(ray, walk, corners);
        if (t == 0.0) profile.x = 0.0;
        float span = min(walk.exit, ray.end) - walk.t;
        if (reliefDeepest(profile, span) > kReliefDepthRounding) return false;
        t = walk.exit;
        if (t >= ray.end) return true;
        float above = -profile.x - (profile.y + profile.z * span) * span;
        if (above > reliefClearance(ray, reliefRise(corners))) return true;
        reliefStepWalk(walk);
    }
    t = ray.end;
    return true;
}

// Whether light from `direction` (tile space, of any length) gets to a point of the surface. A search that
// ran out of steps met nothing.
bool reliefIsLit(vec2 uv, vec3 direction) {
    if (direction.z >= 0.0) return false;
    float aspect = reliefAspect();
    ReliefRay ray;
    ReliefCell cell = reliefCell(uv);
    ray.origin = vec3(uv, reliefInterpolate(cell, reliefCornerDepths(cell)));
    ray.direction = direction / length(vec3(direction.x, aspect * direction.y, direction.z));
    ray.speed = length(vec2(ray.direction.x, aspect * ray.direction.y));
    ray.end = reliefRayEnd(ray.origin, ray.direction, ray.speed, relievoWindow);
    ray.worldLength = 0.0;
    ray.depthScale = relievoDepthScale;
    ray.pixelsPerDepth = kReliefBoundless;
    float clear;
    if (!reliefIsClear(ray, clear)) return false;
    if (clear >= ray.end) return true;
    ray.origin = reliefPoint(ray, ray.end);
    ray.direction = -ray.direction;
    ray.end -= clear;
    return searchRelief(ray).outcome != RELIEVO_OUTCOME_HIT;
}
