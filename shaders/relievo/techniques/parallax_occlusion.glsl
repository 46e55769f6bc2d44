// Parallax occlusion mapping: linear search whose number of steps grows as the view lowers, then the
// crossing of the line through the two samples around the hit (Tatarchuk 2006).
#include "relievo/search/two_phases.glsl"
#include "relievo/search/march.glsl"

uniform int relievoMostSteps;    // at grazing angles
uniform int relievoFewestSteps;  // from straight above

int reliefFind(ReliefRay ray, out ReliefBracket bracket, inout int steps) {
    // Rays that rise are as steep as those that come down.
    float steepness = abs(reliefCosine(ray));
    float count = mix(float(relievoMostSteps), float(relievoFewestSteps), steepness);
    return reliefMarch(ray, int(ceil(count)), bracket, steps);
}

float reliefRefine(ReliefRay ray, ReliefBracket bracket, inout int steps) {
    return reliefSecant(bracket);
}
