// First phase of searches that know how far a ray may go on without harm. Where that is nothing the ray goes
// on by a least step, and so it is off where the surface is thinner than that.
#include "relievo/search/bracket.glsl"

uniform int relievoSkipSteps;
uniform float relievoLeastStep;  // texels

// The t that the ray may go on from a point above the surface: to nowhere past the first hit, or at least to
// a first piercing. The technique's file defines it.
float reliefFreeLength(ReliefRay ray, vec3 point);

int reliefFind(ReliefRay ray, out ReliefBracket bracket, inout int steps) {
    vec2 texels = ray.direction.xy * vec2(reliefMapSize());
    // Steep rays stay within a texel: their least step is the whole ray.
    float least = relievoLeastStep / max(length(texels), 1e-6);
    bracket = ReliefBracket(0.0, 0.0, 0.0, 0.0);
    while (steps < relievoSkipSteps) {
        vec3 point = reliefPoint(ray, bracket.inside);
        bracket.below = point.z - reliefDepth(point.xy);
        if (bracket.below >= 0.0) return RELIEVO_OUTCOME_HIT;
        if (bracket.inside >= ray.end) return RELIEVO_OUTCOME_MISS;
        ++steps;
        bracket.outside = bracket.inside;
        bracket.above = -bracket.below;
        bracket.inside = min(bracket.inside + max(reliefFreeLength(ray, point), least), ray.end);
    }
    return RELIEVO_OUTCOME_EXHAUSTED;
}
