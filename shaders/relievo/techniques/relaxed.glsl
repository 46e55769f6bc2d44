// Relaxed cone stepping: the cones are so wide that a ray may pierce the surface once inside one, so that
// few steps lead through it; binary search finds the crossing (Policarpo, Oliveira 2007). With relaxed
// cones guaranteed on the bilinear surface that crossing is the first hit.
#include "relievo/search/cones.glsl"
#include "relievo/search/result.glsl"

uniform int relievoBinarySteps;

ReliefHit searchRelief(ReliefRay ray) {
    ReliefBracket bracket;
    int steps = 0;
    int outcome = reliefConeMarch(ray, bracket, steps);
    if (reliefIsPierced(outcome, bracket)) reliefBisect(ray, relievoBinarySteps, bracket, steps);
    return reliefResult(ray, bracket.inside, outcome, steps);
}
