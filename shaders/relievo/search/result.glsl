// How a technique reports what it found.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

ReliefHit reliefResult(ReliefRay ray, float t, int outcome, int steps) {
    return ReliefHit(reliefPoint(ray, t), t, outcome, steps, reliefFetchCount);
}
