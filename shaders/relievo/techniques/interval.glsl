// Interval mapping: linear search, then secant search within the step that pierced the surface (Risser,
// Shah, Pattanaik 2006). It takes fewer refinements than relief mapping for the same error.
#include "relievo/search/march.glsl"
#include "relievo/search/result.glsl"

uniform int relievoLinearSteps;
uniform int relievoSecantSteps;

ReliefHit searchRelief(ReliefRay ray) {
    ReliefBracket bracket;
    int steps = 0;
    if (!reliefMarch(ray, relievoLinearSteps, bracket, steps))
        return reliefResult(ray, bracket.inside, RELIEVO_OUTCOME_MISS, steps);
    reliefSecantSearch(ray, relievoSecantSteps, bracket, steps);
    return reliefResult(ray, reliefSecant(bracket), RELIEVO_OUTCOME_HIT, steps);
}
