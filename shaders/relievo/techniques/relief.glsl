// Relief mapping: linear search, then binary search within the step that pierced the surface
// (Policarpo, Oliveira, Comba 2005). The first hit is missed where the linear search steps over it.
#include "relievo/search/march.glsl"
#include "relievo/search/result.glsl"

uniform int relievoLinearSteps;
uniform int relievoBinarySteps;

ReliefHit searchRelief(ReliefRay ray) {
    ReliefBracket bracket;
    int steps = 0;
    if (!reliefMarch(ray, relievoLinearSteps, bracket, steps))
        return reliefResult(ray, bracket.inside, RELIEVO_OUTCOME_MISS, steps);
    reliefBisect(ray, relievoBinarySteps, bracket, steps);
    return reliefResult(ray, bracket.inside, RELIEVO_OUTCOME_HIT, steps);
}
