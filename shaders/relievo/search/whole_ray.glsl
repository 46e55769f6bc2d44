// First phase that does not search: the bracket is the whole ray. A miss when its end lies above the surface.
#include "relievo/search/bracket.glsl"

int reliefFind(ReliefRay ray, out ReliefBracket bracket, inout int steps) {
    bracket = reliefStretch(ray, 0.0, ray.end);
    return bracket.below >= 0.0 ? RELIEVO_OUTCOME_HIT : RELIEVO_OUTCOME_MISS;
}
