// Cone tracing: each texel holds the widest empty cone that stands on it, and a step leads to where
// the ray leaves the cone below it (Dummer 2006; radius form and metric: specification 3.1 and E3).
#include "relievo/search/bisect.glsl"
#include "relievo/search/result.glsl"

uniform sampler2D relievoConeMap;  // ratio, or radius = ratio·D; nearest filter
uniform int relievoConeSteps;
uniform float relievoTolerance;  // in normalised depth: closer than this above the surface is a hit

// Bisections of a step that pierced the surface: cones of texel centres may be a little too wide
// between the centres.
uniform int relievoConeRefinements;

// The length of the step from a point `gap` above a surface of depth `depth` to the side of the cone
// on it: t with speed·t = ratio·(gap − dz·t). A ray that rises as steeply as the cone never leaves it.
float reliefConeStep(ReliefRay ray, float cone, float depth, float gap) {
#ifdef RELIEVO_CONE_RADIUS
    float closing = ray.speed * depth + cone * ray.direction.z;
#else
    float closing = ray.speed + cone * ray.direction.z;
#endif
    return closing > 0.0 ? cone * gap / closing : ray.end;
}

ReliefHit searchRelief(ReliefRay ray) {
    float before = 0.0;
    float t = 0.0;
    int steps = 0;
    while (steps < relievoConeSteps) {
        vec3 point = reliefPoint(ray, t);
        float depth = reliefDepth(point.xy);
        float gap = depth - point.z;
        if (gap <= relievoTolerance) {
            if (gap < -relievoTolerance)
                reliefBisect(ray, relievoConeRefinements, before, t, steps);
            return reliefResult(ray, t, RELIEVO_OUTCOME_HIT, steps);
        }
        if (t >= ray.end) return reliefResult(ray, t, RELIEVO_OUTCOME_MISS, steps);
        ++steps;
        ++reliefFetchCount;
        float cone = textureLod(relievoConeMap, point.xy, 0.0).r;
        before = t;
        t = min(t + reliefConeStep(ray, cone, depth, gap), ray.end);
    }
    return reliefResult(ray, t, RELIEVO_OUTCOME_EXHAUSTED, steps);
}
