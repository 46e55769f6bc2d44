// Linear search: equal steps along the ray, the hit is the first sample in the solid. Its error is up
// to one step, and it steps over features that are thinner than that (thesis 2.3.1).
#include "relievo/search/march.glsl"
#include "relievo/search/result.glsl"

uniform int relievoLinearSteps;

ReliefHit searchRelief(ReliefRay ray) {
    ReliefBracket bracket;
    int steps = 0;
    bool found = reliefMarch(ray, relievoLinearSteps, bracket, steps);
    return reliefResult(ray, bracket.inside,
                        found ? RELIEVO_OUTCOME_HIT : RELIEVO_OUTCOME_MISS, steps);
}
