// Cone tracing: each texel holds the widest empty cone that stands on it, and a step leads to where
// the ray leaves the cone below it (Dummer 2006; radius form and metric: specification 3.1 and E3).
//
// Between texel centres the narrowest cone of the cell's four corners is taken. The nearest one alone
// would be far too wide beside a cliff, and so would be any mean of them. What is left is the
// curvature of the cell; a step that pierced the surface because of it is bisected.
#include "relievo/search/bisect.glsl"
#include "relievo/search/result.glsl"

uniform sampler2D relievoConeMap;  // ratio, or radius = ratio·D
uniform int relievoConeSteps;
uniform float relievoTolerance;  // in normalised depth: closer than this above the surface is a hit
uniform int relievoConeRefinements;  // bisections of a step that pierced the surface

// The least ratio at the corners of a cell with the given depths.
float reliefConeRatio(ReliefCell cell, vec4 depths) {
    ++reliefFetchCount;
    vec4 cones = textureGather(relievoConeMap, cell.gather);
#ifdef RELIEVO_CONE_RADIUS
    // A corner of depth 0 is a highest point: it has no cone, and the radius says nothing.
    const float unlimited = 1e30;
    cones = mix(vec4(unlimited), cones / max(depths, vec4(1e-30)), greaterThan(depths, vec4(0.0)));
#endif
    return min(min(cones.x, cones.y), min(cones.z, cones.w));
}

// The length of the step from a point `gap` above the surface to the side of the cone on it: t with
// speed·t = ratio·(gap − dz·t). A ray that rises as steeply as the cone never leaves it.
float reliefConeStep(ReliefRay ray, float ratio, float gap) {
    float closing = ray.speed + ratio * ray.direction.z;
    return closing > 0.0 ? ratio * gap / closing : ray.end;
}

ReliefHit searchRelief(ReliefRay ray) {
    float before = 0.0;
    float t = 0.0;
    int steps = 0;
    while (steps < relievoConeSteps) {
        vec3 point = reliefPoint(ray, t);
        ReliefCell cell = reliefCell(point.xy);
        vec4 depths = reliefCornerDepths(cell);
        float gap = reliefInterpolate(cell, depths) - point.z;
        if (gap <= relievoTolerance) {
            if (gap < -relievoTolerance)
                reliefBisect(ray, relievoConeRefinements, before, t, steps);
            return reliefResult(ray, t, RELIEVO_OUTCOME_HIT, steps);
        }
        if (t >= ray.end) return reliefResult(ray, t, RELIEVO_OUTCOME_MISS, steps);
        ++steps;
        before = t;
        t = min(t + reliefConeStep(ray, reliefConeRatio(cell, depths), gap), ray.end);
    }
    return reliefResult(ray, t, RELIEVO_OUTCOME_EXHAUSTED, steps);
}
