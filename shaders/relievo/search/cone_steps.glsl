// First phase as it was published (Dummer 2006; Policarpo, Oliveira 2007): steps from cone to cone until a
// point is in the solid, or above it by no more than a tolerance, where the bracket is empty.
#include "relievo/search/bracket.glsl"
#include "relievo/search/cone.glsl"

uniform float relievoTolerance;  // in normalised depth: closer than this above the surface is a hit
#define RELIEVO_SEARCH_TOLERANCE(rise) relievoTolerance

int reliefFind(ReliefRay ray, out ReliefBracket bracket, inout int steps) {
    bracket = ReliefBracket(0.0, 0.0, 0.0, 0.0);
    while (steps < relievoConeSteps) {
        vec3 point = reliefPoint(ray, bracket.inside);
        ReliefCell cell = reliefCell(point.xy);
        vec4 depths = reliefCornerDepths(cell);
        float gap = reliefInterpolate(cell, depths) - point.z;
        bracket.below = -gap;
        if (gap <= relievoTolerance) {
            if (gap >= -relievoTolerance) bracket.outside = bracket.inside;
            return RELIEVO_OUTCOME_HIT;
        }
        if (bracket.inside >= ray.end) return RELIEVO_OUTCOME_MISS;
        ++steps;
        bracket.outside = bracket.inside;
        bracket.above = gap;
        float ratio = reliefConeRatio(ray, point.xy, cell.gather, depths);
        bracket.inside = min(bracket.inside + reliefConeStep(ray, ratio, gap), ray.end);
    }
    return RELIEVO_OUTCOME_EXHAUSTED;
}
