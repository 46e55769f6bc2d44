// The walk of a ray over the bilinear cells of a relief, and the first hit in one of them.
#include "relievo/maps.glsl"
#include "relievo/search/result.glsl"
#include "relievo/search/walk.glsl"

#ifdef RELIEVO_WRAP_CLAMP
const bool kReliefIsClamped = true;
#else
const bool kReliefIsClamped = false;
#endif

ReliefWalk reliefBeginWalk(ReliefRay ray) {
    return reliefBeginWalk(ray.origin.xy, ray.direction.xy, reliefMapSize(), kReliefIsClamped);
}

// cell mod period, in [0, period).
int reliefModulo(int cell, int period) {
    int place = cell - period * int(floor(float(cell) / float(period)));
    // The quotient may be rounded up or down to the next integer.
    return place < 0 ? place + period : (place >= period ? place - period : place);
}

// The depths at the corners of the walk's cell, in the order of textureGather: (0,1), (1,1), (1,0), (0,0).
vec4 reliefWalkCorners(ReliefWalk walk) {
    ++reliefFetchCount;
    return reliefGather(relievoDepthMap, reliefWalkGather(walk));
}

// How much the depth differs between the corners of a cell, at most.
float reliefRise(vec4 corners) {
    vec2 least = min(corners.xy, corners.zw);
    vec2 most = max(corners.xy, corners.zw);
    return max(most.x, most.y) - min(least.x, least.y);
}

// The surface along a ray in the walk's cell, whose corners are given: z − D is x + y·s + z·s², s counted
// from where the ray enters the cell.
vec3 reliefProfile(ReliefRay ray, ReliefWalk walk, vec4 corners) {
    vec3 depths = reliefAlongCell(walk, corners);
    return vec3(ray.origin.z + walk.t * ray.direction.z - depths.x, ray.direction.z - depths.y, -depths.z);
}

// The t at which the ray with this profile, above the surface where it enters the walk's cell, first
// meets the surface there; kReliefBoundless when it leaves the cell above it, or up to a rounding below.
// A ray that enters below the surface, which rounding may cause, meets it at once.
float reliefFirstMeeting(vec3 profile, ReliefWalk walk) {
    if (profile.x >= 0.0) return walk.t;
    float discriminant = profile.y * profile.y - 4.0 * profile.z * profile.x;
    if (discriminant < 0.0) return kReliefBoundless;
    // The first positive root in the form in which nothing cancels.
    float root = sqrt(discriminant);
    float numerator = profile.y >= 0.0 ? -2.0 * profile.x : root - profile.y;
    float denominator = profile.y >= 0.0 ? profile.y + root : 2.0 * profile.z;
    float s = denominator > 0.0 ? numerator / denominator : kReliefBoundless;
    return walk.t + s <= walk.exit ? walk.t + s : kReliefBoundless;
}

// The same from the map.
float reliefHitInCell(ReliefRay ray, ReliefWalk walk) {
    return reliefFirstMeeting(reliefProfile(ray, walk, reliefWalkCorners(walk)), walk);
}

// All that is left of a ray is free.
ReliefHit reliefAtEnd(ReliefRay ray, int steps) {
    return reliefResult(ray, ray.end, RELIEVO_OUTCOME_MISS, steps);
}
