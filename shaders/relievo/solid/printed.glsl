// What the searches of chapter 4 of the thesis have in common (Halli 2009, algorithms 4.1 to 4.5): they step
// by the distance to the shape from where the ray comes in, as often as they may, and shade what they have
// come to. They are here as they were printed, faults included, to be compared with, but for two corrections
// (specification 9): a step is divided by the length of the ray (E1), and a search that has not come to the
// surface says that its steps ran out (E10). It is shaded as if it had.
//
// Looks that cannot change the answer are left out: where a step has no length all others have none, and what
// has left the window does not come back.
#include "relievo/fetches.glsl"
#include "relievo/platform.glsl"
#include "relievo/solid/compound.glsl"

#define RELIEVO_SOLID_SHADES_EXHAUSTED 1

uniform float relievoSolidTolerance;  // texels in front of the surface at which a search has come to it

// The distance at a place of the map, in texels from its corner; what a linear filter gives.
float solidLinearLookup(sampler2D map, vec2 place) {
    ++reliefFetchCount;
    vec2 cell = floor(place - 0.5);
    vec2 part = place - 0.5 - cell;
    vec4 corners = reliefGather(map, (cell + 1.0) / vec2(textureSize(map, 0)));
    return mix(mix(corners.w, corners.z, part.x), mix(corners.x, corners.y, part.x), part.y);
}

// Texels that a ray goes across an extrusion in one unit of t; a vertical one next to none.
float solidPrintedSpeed(SolidPath path) {
    return max(length(path.direction.xy * vec2(textureSize(relievoSolidDistances0, 0))), 1e-20);
}

// How far the extended shape is from the ray at t, 0 inside.
float solidPrintedDistance(SolidPath path, float extension, float t) {
    vec2 place = solidPoint(path, t).xy * vec2(textureSize(relievoSolidDistances0, 0));
    return max(solidLinearLookup(relievoSolidDistances0, place) - extension, 0.0);
}

// A look that the printed search does not take, to say how it ended: it is not counted.
float solidPrintedRest(SolidPath path, float extension, float t) {
    float distance = solidPrintedDistance(path, extension, t);
    --reliefFetchCount;
    return distance;
}

// From t on by steps of the distance to the extended shape (algorithms 4.1 and 4.2).
void solidStepToExtension(SolidPath path, float extension, inout float t) {
    float speed = solidPrintedSpeed(path);
    for (int k = 0; k < relievoSolidSteps && t <= path.leave; ++k) {
        ++solidSteps;
        float distance = solidPrintedDistance(path, extension, t);
        if (distance <= 0.0) break;
        t += distance / speed;
    }
}

// What a search has come to at t, `rest` texels in front of the surface.
SolidHit solidPrintedHit(SolidRay ray, SolidPath path, float t, float rest, vec2 normal) {
    if (!(t <= path.leave)) return solidMiss(ray, ray.end, RELIEVO_OUTCOME_MISS);
    SolidCursor cursor = solidCursorAt(0, path);
    cursor.t = t;
    cursor.side = t <= path.enter ? path.enterNormal : vec3(0.0);
    cursor.normal = normal;
    SolidHit hit = solidHitOf(ray, 0, path, cursor);
    if (rest > relievoSolidTolerance) hit.outcome = RELIEVO_OUTCOME_EXHAUSTED;
    return hit;
}
