// Equal steps along a ray until one lies in the solid.
#include "relievo/search/bracket.glsl"

// Looks at t = end·i/count for i = 1 … count, and returns the outcome. On a hit the bracket is the sample in
// the solid and the one before. Features between two samples are missed.
int reliefMarch(ReliefRay ray, int count, out ReliefBracket bracket, inout int steps) {
    bracket = ReliefBracket(0.0, 0.0, 0.0, 0.0);
    for (int i = 1; i <= count; ++i) {
        ++steps;
        bracket.inside = ray.end * (float(i) / float(count));
        vec3 point = reliefPoint(ray, bracket.inside);
        bracket.below = point.z - reliefDepth(point.xy);
        if (bracket.below >= 0.0) return RELIEVO_OUTCOME_HIT;
        bracket.outside = bracket.inside;
        bracket.above = -bracket.below;
    }
    return RELIEVO_OUTCOME_MISS;
}
