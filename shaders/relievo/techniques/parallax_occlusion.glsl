// Parallax occlusion mapping: linear search whose number of steps grows as the view lowers, then the
// crossing of the line through the two samples around the hit (Tatarchuk 2006).
#include "relievo/search/march.glsl"
#include "relievo/search/result.glsl"

uniform int relievoMostSteps;    // at grazing angles
uniform int relievoFewestSteps;  // from straight above

ReliefHit searchRelief(ReliefRay ray) {
    float count = mix(float(relievoMostSteps), float(relievoFewestSteps), reliefCosine(ray));
    ReliefBracket bracket;
    int steps = 0;
    if (!reliefMarch(ray, int(ceil(count)), bracket, steps))
        return reliefResult(ray, bracket.inside, RELIEVO_OUTCOME_MISS, steps);
    return reliefResult(ray, reliefSecant(bracket), RELIEVO_OUTCOME_HIT, steps);
}
