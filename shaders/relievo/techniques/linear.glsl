// Linear search: equal steps along the ray, the hit is the first sample in the solid. Its error is up
// to one step, and it steps over features that are thinner than that (thesis 2.3.1).
#include "relievo/search/two_phases.glsl"
#include "relievo/search/linear.glsl"

float reliefRefine(ReliefRay ray, ReliefBracket bracket, inout int steps) { return bracket.inside; }
