// Binary search alone, over the whole ray: finds some crossing of the surface, the first one only where
// there is no other (thesis 2.3.2).
#include "relievo/search/bracket.glsl"
#include "relievo/search/result.glsl"

uniform int relievoBinarySteps;

ReliefHit searchRelief(ReliefRay ray) {
    ReliefBracket bracket;
    int steps = 0;
    if (!reliefWholeRay(ray, bracket))
        return reliefResult(ray, ray.end, RELIEVO_OUTCOME_MISS, steps);
    reliefBisect(ray, relievoBinarySteps, bracket, steps);
    return reliefResult(ray, bracket.inside, RELIEVO_OUTCOME_HIT, steps);
}
