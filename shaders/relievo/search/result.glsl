// How a technique reports what it found.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

ReliefHit reliefResult(ReliefRay ray, float t, int outcome, int steps) {
    return ReliefHit(reliefPoint(ray, t), t, outcome, steps, reliefFetchCount);
}

// A hit at t, or a miss when the ray ends before.
ReliefHit reliefHitWithin(ReliefRay ray, float t, int steps) {
    return reliefResult(ray, min(t, ray.end),
                        t <= ray.end ? RELIEVO_OUTCOME_HIT : RELIEVO_OUTCOME_MISS, steps);
}
