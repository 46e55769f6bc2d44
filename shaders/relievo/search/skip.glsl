// Searches that know how far a ray may go on without harm. The file that includes this one defines before
//
//   float reliefFreeLength(ReliefRay ray, vec3 point);
//
// the t that the ray may go on from a point above the surface: to nowhere past the first hit, or at least
// to a first piercing. Where that is nothing the ray goes on by a least step, and so it is off where the
// surface is thinner than that.
#include "relievo/search/bracket.glsl"
#include "relievo/search/result.glsl"

uniform int relievoSkipSteps;
uniform float relievoLeastStep;  // texels
uniform int relievoBinarySteps;  // halvings of the step that pierced the surface

ReliefHit searchRelief(ReliefRay ray) {
    vec2 texels = ray.direction.xy * vec2(reliefMapSize());
    // Steep rays stay within a texel: their least step is the whole ray.
    float least = relievoLeastStep / max(length(texels), 1e-6);
    ReliefBracket bracket = ReliefBracket(0.0, 0.0, 0.0, 0.0);
    int steps = 0;
    while (steps < relievoSkipSteps) {
        vec3 point = reliefPoint(ray, bracket.inside);
        bracket.below = point.z - reliefDepth(point.xy);
        if (bracket.below >= 0.0) {
            if (bracket.inside > 0.0) reliefBisect(ray, relievoBinarySteps, bracket, steps);
            return reliefResult(ray, bracket.inside, RELIEVO_OUTCOME_HIT, steps);
        }
        if (bracket.inside >= ray.end)
            return reliefResult(ray, bracket.inside, RELIEVO_OUTCOME_MISS, steps);
        ++steps;
        bracket.outside = bracket.inside;
        bracket.above = -bracket.below;
        bracket.inside = min(bracket.inside + max(reliefFreeLength(ray, point), least), ray.end);
    }
    return reliefResult(ray, bracket.inside, RELIEVO_OUTCOME_EXHAUSTED, steps);
}
