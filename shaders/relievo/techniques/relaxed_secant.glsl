// Relaxed cone stepping as in techniques/relaxed.glsl, with secant search for the crossing: fewer samples
// where the surface is even.
#include "relievo/search/cones.glsl"
#include "relievo/search/result.glsl"

uniform int relievoSecantSteps;

ReliefHit searchRelief(ReliefRay ray) {
    ReliefBracket bracket;
    int steps = 0;
    int outcome = reliefConeMarch(ray, bracket, steps);
    if (!reliefIsPierced(outcome, bracket)) return reliefResult(ray, bracket.inside, outcome, steps);
    reliefSecantSearch(ray, relievoSecantSteps, bracket, steps);
    return reliefResult(ray, reliefSecant(bracket), outcome, steps);
}
