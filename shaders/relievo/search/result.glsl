// How a technique reports what it found.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

// Whether the point is on the bottom of the relief, up to the rounding of the ray's end.
bool reliefIsBottom(vec3 point) { return point.z >= 1.0 - 1e-6; }

// At the bottom everything is solid: a search that gets there has hit it, even where the relief is as deep
// and rounding left the end of the ray above it.
ReliefHit reliefResult(ReliefRay ray, float t, int outcome, int steps) {
    vec3 point = reliefPoint(ray, t);
    if (outcome == RELIEVO_OUTCOME_MISS && reliefIsBottom(point)) outcome = RELIEVO_OUTCOME_HIT;
    return ReliefHit(point, t, outcome, steps, reliefFetchCount);
}

// A hit at t, or a miss when the ray ends before. What is behind the ray's start is a hit there.
ReliefHit reliefHitWithin(ReliefRay ray, float t, int steps) {
    return reliefResult(ray, clamp(t, 0.0, ray.end),
                        t <= ray.end ? RELIEVO_OUTCOME_HIT : RELIEVO_OUTCOME_MISS, steps);
}
