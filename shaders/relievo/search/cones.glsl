// First phase by cones on the surface: each texel holds the widest one that stands on it (specification 3.1 and E3).
//
// Cones with a guarantee on the bilinear surface (RELIEVO_CONE_BILINEAR) hold for every apex in their
// texel's square: the nearest one is taken. Cones of texel centres hold there only: between them the
// narrowest cone of the cell's four corners is taken. The nearest one alone would be far too wide
// beside a cliff, and so would be any mean of them; what is left is the curvature of the cell.
#include "relievo/search/bracket.glsl"

uniform sampler2D relievoConeMap;  // ratio, or radius = ratio·D
uniform int relievoConeSteps;
uniform float relievoTolerance;  // in normalised depth: closer than this above the surface is a hit
#define RELIEVO_SEARCH_TOLERANCE(rise) relievoTolerance

// The ratio of the cone at a point of the surface: a cell with the given corner depths.
float reliefConeRatio(vec2 uv, ReliefCell cell, vec4 depths) {
    ++reliefFetchCount;
#ifdef RELIEVO_CONE_BILINEAR
    return textureLod(relievoConeMap, uv, float(reliefLevel)).r;
#else
    vec4 cones = reliefGather(relievoConeMap, cell.gather);
#ifdef RELIEVO_CONE_RADIUS
    // A corner of depth 0 is a highest point: it has no cone, and the radius says nothing.
    const float unlimited = 1e30;
    cones = mix(vec4(unlimited), cones / max(depths, vec4(1e-30)), greaterThan(depths, vec4(0.0)));
#endif
    return min(min(cones.x, cones.y), min(cones.z, cones.w));
#endif
}

// The length of the step from a point `gap` above the surface to the side of the cone on it: t with
// speed·t = ratio·(gap − dz·t). A ray that rises as steeply as the cone never leaves it.
float reliefConeStep(ReliefRay ray, float ratio, float gap) {
    float closing = ray.speed + ratio * ray.direction.z;
    return closing > 0.0 ? ratio * gap / closing : ray.end;
}

// Steps from cone to cone until a point is in the solid, or off the surface by no more than the tolerance,
// where the bracket is empty.
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
        float ratio = reliefConeRatio(point.xy, cell, depths);
        bracket.inside = min(bracket.inside + reliefConeStep(ray, ratio, gap), ray.end);
    }
    return RELIEVO_OUTCOME_EXHAUSTED;
}
