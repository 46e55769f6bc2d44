// Searches that find a stretch of the ray with a crossing in it, and then the crossing: what most techniques
// are (thesis, table 2.1). The technique's file includes one file for each phase, or defines it:
//
//   first phase    linear.glsl, cone_steps.glsl, cones.glsl, skip.glsl, whole_ray.glsl
//   second phase   binary.glsl, secant.glsl
#include "relievo/search/bracket.glsl"
#include "relievo/search/result.glsl"

// First phase: looks for a point in the solid. Returns the outcome. On a hit the bracket holds the crossing,
// or is empty (inside = outside) where that needs no refinement; otherwise its end is the last point reached.
int reliefFind(ReliefRay ray, out ReliefBracket bracket, inout int steps);

// Second phase: the t of the crossing in a bracket.
float reliefRefine(ReliefRay ray, ReliefBracket bracket, inout int steps);

ReliefHit searchRelief(ReliefRay ray) {
    ReliefBracket bracket;
    int steps = 0;
    int outcome = reliefFind(ray, bracket, steps);
    float t = bracket.inside;
    if (outcome == RELIEVO_OUTCOME_HIT && bracket.outside < bracket.inside)
        t = reliefRefine(ray, bracket, steps);
    return reliefResult(ray, t, outcome, steps);
}
