// Parallax mapping with offset limiting: the shift is never longer than the depth (Welsh 2004). Steadier
// than parallax mapping at grazing angles, and flatter.
#include "relievo/search/result.glsl"

ReliefHit searchRelief(ReliefRay ray) {
    float gap = reliefDepth(ray.origin.xy) - ray.origin.z;
    return reliefHitWithin(ray, gap * reliefDepthLength(ray), 1);
}
