// The plane halfway between the least and the greatest depth of a relief: half of what lies between is
// the most by which a point on it is too deep or not deep enough.
#include "relievo/search/result.glsl"

uniform vec2 relievoDepthRange;  // the least and the greatest depth

ReliefHit reliefMiddle(ReliefRay ray) {
    float depth = 0.5 * (relievoDepthRange.x + relievoDepthRange.y);
    float t = ray.direction.z > 0.0 ? (depth - ray.origin.z) / ray.direction.z : kReliefBoundless;
    return reliefHitWithin(ray, t, 0);
}
