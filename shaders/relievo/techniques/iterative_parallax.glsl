// Iterative parallax mapping: slope-aware parallax again and again, each time from where the last one led to
// (Premecz 2006; thesis 2.2.1). It converges on smooth reliefs; where it does not, it ends wherever the
// steps end.
#include "relievo/search/result.glsl"
#include "relievo/search/slope.glsl"

uniform int relievoParallaxSteps;

ReliefHit searchRelief(ReliefRay ray) {
    float t = 0.0;
    for (int i = 0; i < relievoParallaxSteps; ++i) t = reliefSlopeStep(ray, t);
    return reliefResult(ray, t, RELIEVO_OUTCOME_HIT, relievoParallaxSteps);
}
