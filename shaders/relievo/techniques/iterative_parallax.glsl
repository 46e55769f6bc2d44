// Iterative parallax mapping with slope information: the ray goes on by how far it is above the surface,
// shortened where that is steep, again and again (Premecz 2006). One step is slope-aware parallax. It
// converges on smooth reliefs; where it does not, it ends wherever the steps end.
#include "relievo/search/result.glsl"

uniform int relievoParallaxSteps;

ReliefHit searchRelief(ReliefRay ray) {
    float depthLength = reliefDepthLength(ray);
    float t = 0.0;
    for (int i = 0; i < relievoParallaxSteps; ++i) {
        vec3 point = reliefPoint(ray, t);
        float gap = reliefDepth(point.xy) - point.z;
        vec2 slope = ray.depthScale * reliefGradient(point.xy);
        float normalZ = inversesqrt(1.0 + dot(slope, slope));
        t = clamp(t + gap * normalZ * depthLength, 0.0, ray.end);
    }
    return reliefResult(ray, t, RELIEVO_OUTCOME_HIT, relievoParallaxSteps);
}
