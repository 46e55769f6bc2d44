// Parallax with the slope of the relief: the surface around a point is taken to be even, and as steep as it
// is there (Premecz 2006; thesis 2.1.4). The division by the cosine between ray and normal is left out, as
// in parallax with offset limiting: it has no bound.
#include "relievo/ray.glsl"
#include "relievo/slopes.glsl"

// The t up to which a ray at t goes on: by how far it is above the surface, times the height of the unit
// normal there. Within [0, end].
float reliefSlopeStep(ReliefRay ray, float t) {
    vec3 point = reliefPoint(ray, t);
    float gap = reliefDepth(point.xy) - point.z;
    vec2 slope = ray.depthScale * reliefGradient(point.xy);
    float normalZ = inversesqrt(1.0 + dot(slope, slope));
    return clamp(t + gap * normalZ * reliefDepthLength(ray), 0.0, ray.end);
}
