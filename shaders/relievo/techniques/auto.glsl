// As much of a search as the picture shows (ours): points may be out of place by a fraction of a pixel.
//
// - Where half of the relief's depth is less than that, the plane halfway through it will do, and nothing
//   is looked up.
// - Everywhere else roof cones lead to the first hit, between the least and the greatest depth of the
//   relief only, and no further than to where what is left of the depth is less than the target.
// - In between the hit turns into that plane, so that no border is seen. With half of the depth n times
//   the target, n from 1 to 2, points are drawn at n − 1 times their distance from the plane, which is off by
//   (2 − n)·n times the target at most; and the search leaves out n − 1 times the target at the bottom, where
//   they are off by n − (n − 1)·(n − (n − 1)) times the target, which is once.
//
// Error: relievoPixelError. Cost: that of techniques/exact.glsl or less. Light rays that begin at such hits
// would begin above or below the relief: programs with shadows/search.glsl or soft.glsl take
// techniques/exact.glsl instead.
#include "relievo/search/middle.glsl"
#include "relievo/search/roofs.glsl"

uniform float relievoPixelError;  // pixels by which a point may be out of place

// Searches from the least depth of the relief to `bottom`: what comes as deep as that is a hit there. A ray
// that does not come down has no such part, and one that begins below has begun it.
ReliefHit reliefSearchBetween(ReliefRay ray, float bottom) {
    float lead = 0.0;
    float end = ray.end;
    if (ray.direction.z > 0.0) {
        lead = max((relievoDepthRange.x - ray.origin.z) / ray.direction.z, 0.0);
        end = min(max((bottom - ray.origin.z) / ray.direction.z, lead), ray.end);
    }
    if (lead > ray.end) return reliefResult(ray, ray.end, RELIEVO_OUTCOME_MISS, 0);
    ReliefRay part = ray;
    part.origin = reliefPoint(ray, lead);
    part.end = end - lead;
    // The only call: where pixels are drawn together each one takes the time of a search.
    ReliefHit hit = reliefSearchRoofs(part);
    if (hit.outcome == RELIEVO_OUTCOME_MISS && end < ray.end) hit.outcome = RELIEVO_OUTCOME_HIT;
    return reliefResult(ray, lead + hit.t, hit.outcome, hit.steps);
}

ReliefHit searchRelief(ReliefRay ray) {
    float halfDepth = 0.5 * (relievoDepthRange.y - relievoDepthRange.x);
    float targets = halfDepth * ray.pixelsPerDepth / relievoPixelError;
    ReliefHit middle = reliefMiddle(ray);
    if (targets <= 1.0) return middle;
    float found = min(targets - 1.0, 1.0);
    ReliefHit hit = reliefSearchBetween(ray, relievoDepthRange.y - found * halfDepth / targets);
    if (found < 1.0 && hit.outcome == RELIEVO_OUTCOME_HIT && middle.outcome == RELIEVO_OUTCOME_HIT)
        return reliefResult(ray, mix(middle.t, hit.t, found), RELIEVO_OUTCOME_HIT, hit.steps);
    return hit;
}
