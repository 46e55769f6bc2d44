// Secant search alone, over the whole ray: like binary search, but the next sample is where the line
// through the ends crosses (thesis 2.3.2). Quick on even slopes, slow where one end stays.
#include "relievo/search/bracket.glsl"
#include "relievo/search/result.glsl"

uniform int relievoSecantSteps;

ReliefHit searchRelief(ReliefRay ray) {
    ReliefBracket bracket;
    int steps = 0;
    if (!reliefWholeRay(ray, bracket))
        return reliefResult(ray, ray.end, RELIEVO_OUTCOME_MISS, steps);
    reliefSecantSearch(ray, relievoSecantSteps, bracket, steps);
    return reliefResult(ray, reliefSecant(bracket), RELIEVO_OUTCOME_HIT, steps);
}
