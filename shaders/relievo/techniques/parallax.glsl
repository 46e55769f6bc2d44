// Parallax mapping: the surface is taken to be level, as deep as it is where the ray enters (Kaneko et
// al. 2001). Far off at grazing angles, where the shift grows without bound.
#include "relievo/search/result.glsl"

ReliefHit searchRelief(ReliefRay ray) {
    float gap = reliefDepth(ray.origin.xy) - ray.origin.z;
    float t = ray.direction.z > 0.0 ? gap / ray.direction.z : RELIEVO_MAXIMUM_REACH;
    return reliefHitWithin(ray, t, 1);
}
